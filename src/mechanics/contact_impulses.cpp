#include "coilwright/mechanics/contact_impulses.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mechanics/lemke.hpp"

namespace coilwright::mechanics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void check_friction(double value, const char* field, int contact) {
  if (!std::isfinite(value) || value < 0.0)
    throw std::invalid_argument(fmt::format("contact {}: {} must be finite and >= 0; got {}", contact, field, value));
}

void check(const CoordinateMatrix& mass, const CoordinateVector& velocity, std::span<const Contact> contacts) {
  if (mass.rows() != velocity.size() || mass.cols() != velocity.size())
    throw std::invalid_argument(
        fmt::format("mass must be ({0}, {0}); got ({1}, {2})", velocity.size(), mass.rows(), mass.cols()));
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
    const Contact& contact = contacts[i];
    if (contact.normal.size() != velocity.size() || contact.tangent.size() != velocity.size())
      throw std::invalid_argument(fmt::format("contact {}: rows must have {} entries; got {} and {}", i,
                                              velocity.size(), contact.normal.size(), contact.tangent.size()));
    check_friction(contact.friction.along, "friction.along", i);
    check_friction(contact.friction.against, "friction.against", i);
  }
}

// The contacts by their impulses: speeds = response * impulses + free speeds, normals first, then tangents. Scaled so
// that the mean response and the largest free speed are one: impulses then are of order one, too.
struct Contacts {
  MatrixXd rows;      // (2c, n)
  MatrixXd mobility;  // mass^-1 rows^T, (n, 2c)
  MatrixXd response;  // (2c, 2c)
  VectorXd speeds;    // free
  double speed_unit{1.0};
  double impulse_unit{1.0};
};

Contacts contacts_of(const CoordinateMatrix& mass, const CoordinateVector& velocity, std::span<const Contact> list) {
  const auto count = static_cast<Eigen::Index>(list.size());
  Contacts out;
  out.rows.resize(2 * count, velocity.size());
  for (int i = 0; i < count; ++i) {
    out.rows.row(i) = list[i].normal;
    out.rows.row(count + i) = list[i].tangent;
  }
  const Eigen::LLT<CoordinateMatrix> factor(mass);
  if (factor.info() != Eigen::Success) throw std::invalid_argument("mass must be positive definite");
  out.mobility = out.rows.transpose();
  for (int i = 0; i < 2 * count; ++i) out.mobility.col(i) = factor.solve(CoordinateVector(out.mobility.col(i)));
  out.response = out.rows * out.mobility;
  out.speeds = out.rows * velocity;
  if (!out.response.allFinite() || !out.speeds.allFinite())
    throw std::invalid_argument("mass, velocities and contacts must be finite");
  const double speed = out.speeds.cwiseAbs().maxCoeff();
  const double response = out.response.diagonal().mean();
  if (speed > 0.0) out.speed_unit = speed;
  if (response > 0.0) out.impulse_unit = out.speed_unit / response;
  out.speeds /= out.speed_unit;
  out.response *= out.impulse_unit / out.speed_unit;
  return out;
}

// Unknowns: normal impulses n; b and c, by which friction pushes along +tangent with against * b and along -tangent
// with along * c, b + c <= n; s, which is what slides, times its coefficient. With the coefficients in the columns and
// not in the bounds the matrix is copositive, so that Lemke's method finds an answer if there is one, and zero is
// allowed.
struct Unknowns {
  MatrixXd to_impulses;  // (2c, 3c)
  MatrixXd matrix;
  VectorXd constant;
};

Unknowns unknowns_of(const Contacts& contacts, std::span<const Contact> list) {
  const auto count = static_cast<Eigen::Index>(list.size());
  Unknowns out{MatrixXd::Zero(2 * count, 3 * count), MatrixXd::Zero(4 * count, 4 * count), VectorXd::Zero(4 * count)};
  for (int i = 0; i < count; ++i) {
    out.to_impulses(i, i) = 1.0;
    out.to_impulses(count + i, count + i) = list[i].friction.against;
    out.to_impulses(count + i, 2 * count + i) = -list[i].friction.along;
    out.matrix(count + i, 3 * count + i) = 1.0;
    out.matrix(2 * count + i, 3 * count + i) = 1.0;
    out.matrix(3 * count + i, i) = 1.0;
    out.matrix(3 * count + i, count + i) = -1.0;
    out.matrix(3 * count + i, 2 * count + i) = -1.0;
  }
  out.matrix.topLeftCorner(3 * count, 3 * count) = out.to_impulses.transpose() * contacts.response * out.to_impulses;
  out.constant.head(3 * count) = out.to_impulses.transpose() * contacts.speeds;
  return out;
}

// How far the impulses are from what contact and friction ask for, over the speed unit: each must be what is left of it
// when its speed is taken off and it is put back into its bounds.
double fault_of(const Contacts& contacts, std::span<const Contact> list, const VectorXd& impulses) {
  const auto count = static_cast<Eigen::Index>(list.size());
  const VectorXd speeds = contacts.response * impulses + contacts.speeds;
  double fault = 0.0;
  for (int i = 0; i < count; ++i) {
    const double normal = std::max(0.0, impulses[i]);
    fault = std::max(fault, std::abs(impulses[i] - std::max(0.0, impulses[i] - speeds[i])));
    const double pushed = std::clamp(impulses[count + i] - speeds[count + i], -list[i].friction.along * normal,
                                     list[i].friction.against * normal);
    fault = std::max(fault, std::abs(impulses[count + i] - pushed));
  }
  return fault;
}

// What Lemke's method found, once more without its rounding: which contacts hold, slide or are open is kept, and the
// speeds that must be zero are made so by the smallest change of the impulses. Where two rows are alike to eight digits
// the pivots are as small.
VectorXd refined(const Contacts& contacts, std::span<const Contact> list, const Unknowns& unknowns,
                 const VectorXd& found) {
  const int count = static_cast<int>(found.size()) / 4;
  const VectorXd impulses = unknowns.to_impulses * found.head(3 * count);
  const Eigen::Index free_speeds = Eigen::Index{2} * count;
  MatrixXd freedom = MatrixXd::Zero(free_speeds, free_speeds);
  std::vector<int> rows;
  for (int i = 0; i < count; ++i) {
    if (!(found[i] > 0.0)) continue;
    // Without friction nothing slides against a resistance, and nothing is held.
    const bool has_friction = list[i].friction.along > 0.0 || list[i].friction.against > 0.0;
    const bool slides = !has_friction || found[3 * count + i] > 0.0;
    freedom(i, static_cast<int>(rows.size())) = 1.0;
    if (slides) freedom(count + i, static_cast<int>(rows.size())) = impulses[count + i] / impulses[i];
    rows.push_back(i);
    if (slides) continue;
    freedom(count + i, static_cast<int>(rows.size())) = 1.0;
    rows.push_back(count + i);
  }
  const int size = static_cast<int>(rows.size());
  const MatrixXd ways = freedom.leftCols(size);
  const VectorXd speeds = contacts.response * impulses + contacts.speeds;
  const MatrixXd response = contacts.response * ways;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> held;
  held.setThreshold(1e-9);  // below, two rows are the same
  held.compute(response(rows, Eigen::all));
  const VectorXd change = held.solve(-speeds(rows));
  VectorXd out = impulses + ways * change;
  out.head(count) = out.head(count).cwiseMax(0.0);
  return out;
}

// One way to solve the problem. Where contacts give way a little, rows that are almost alike no longer make pivots that
// are almost zero; each further round starts from the impulses of the one before, which takes the give off again
// (Rockafellar's proximal point method).
struct Attempt {
  LemkeTolerances tolerances;
  double give{};  // of a contact, over the mean response
  int rounds = 1;
};

// The best impulses of all attempts.
class BestImpulses {
 public:
  BestImpulses(const Contacts& contacts, std::span<const Contact> list) : contacts_(contacts), list_(list) {}

  void consider(VectorXd impulses) {
    const double fault = fault_of(contacts_, list_, impulses);
    if (!(fault < fault_)) return;
    fault_ = fault;
    impulses_ = std::move(impulses);
  }
  [[nodiscard]] double fault() const { return fault_; }
  [[nodiscard]] const VectorXd& impulses() const { return impulses_; }

 private:
  const Contacts& contacts_;
  std::span<const Contact> list_;
  VectorXd impulses_;
  double fault_ = std::numeric_limits<double>::infinity();
};

// What is promised of every answer, over the largest speed.
constexpr double allowed = 1e-8;
// A body that is wedged would be held by impulses ten thousand times those of its neighbours, or hardly at all: their
// answers differ by less than this.
constexpr double allowed_of_wedged = 1e-6;

void attempt_impulses(const Attempt& attempt, const Contacts& contacts, const Unknowns& unknowns,
                      std::span<const Contact> list, BestImpulses& best) {
  const auto pushes = 3 * static_cast<Eigen::Index>(list.size());
  MatrixXd matrix = unknowns.matrix;
  VectorXd constant = unknowns.constant;
  matrix.topLeftCorner(pushes, pushes) += attempt.give * unknowns.to_impulses.transpose() * unknowns.to_impulses;
  for (int round = 0; round < attempt.rounds; ++round) {
    const std::optional<VectorXd> found = lemke(matrix, constant, attempt.tolerances);
    if (!found) return;
    const VectorXd impulses = unknowns.to_impulses * found->head(pushes);
    best.consider(impulses);
    if (best.fault() < 0.1 * allowed) return;
    best.consider(refined(contacts, list, unknowns, *found));
    if (best.fault() < allowed) return;
    constant.head(pushes) = unknowns.constant.head(pushes) - attempt.give * unknowns.to_impulses.transpose() * impulses;
  }
}

VectorXd impulses_of(const Contacts& contacts, std::span<const Contact> list) {
  const Unknowns unknowns = unknowns_of(contacts, list);
  constexpr std::array attempts = {
      Attempt{{.pivot = 1e-9, .tie = 1e-10}}, Attempt{{.pivot = 1e-9, .tie = 1e-10}, 1e-7, 10},
      Attempt{{.pivot = 1e-9, .tie = 1e-10}, 1e-5, 20}, Attempt{{.pivot = 1e-8, .tie = 1e-11}},
      Attempt{{.pivot = 1e-9, .tie = 1e-10}, 1e-3, 200}};
  BestImpulses best(contacts, list);
  for (const Attempt& each : attempts) {
    attempt_impulses(each, contacts, unknowns, list, best);
    if (best.fault() < allowed) return best.impulses();
  }
  if (best.fault() < allowed_of_wedged) return best.impulses();
  throw std::runtime_error(fmt::format("contact: no impulses of {} contacts keep all conditions", list.size()));
}

}  // namespace

ContactStep contact_impulses(const CoordinateMatrix& mass, const CoordinateVector& free_velocity,
                             std::span<const Contact> contacts) {
  check(mass, free_velocity, contacts);
  ContactStep out{free_velocity, std::vector<ContactImpulse>(contacts.size())};
  if (contacts.empty()) return out;
  const Contacts closed = contacts_of(mass, free_velocity, contacts);
  const VectorXd impulses = closed.impulse_unit * impulses_of(closed, contacts);
  out.velocities += closed.mobility * impulses;
  const VectorXd speeds = closed.rows * out.velocities;
  const int count = static_cast<int>(contacts.size());
  for (int i = 0; i < count; ++i)
    out.impulses[i] = {.normal = impulses[i],
                       .tangential = impulses[count + i],
                       .normal_speed = speeds[i],
                       .sliding_speed = speeds[count + i]};
  return out;
}

}  // namespace coilwright::mechanics
