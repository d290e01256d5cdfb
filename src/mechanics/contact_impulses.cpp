#include "coilwright/mechanics/contact_impulses.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/algebra/minimum_norm.hpp"
#include "coilwright/mechanics/cholesky_solve.hpp"
#include "mechanics/lemke.hpp"

namespace coilwright::mechanics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void check_friction(double value, const char* field, int contact) {
  if (!std::isfinite(value) || value < 0.0)
    throw std::invalid_argument(fmt::format("contact {}: {} must be finite and >= 0; got {}", contact, field, value));
}

using MassFactor = Eigen::LLT<CoordinateMatrix>;

void check(Eigen::Index rows, Eigen::Index columns, const CoordinateVector& velocity) {
  if (rows != velocity.size() || columns != velocity.size())
    throw std::invalid_argument(fmt::format("mass must be ({0}, {0}); got ({1}, {2})", velocity.size(), rows, columns));
}

void check(const MassFactor& mass, const CoordinateVector& velocity, std::span<const Contact> contacts) {
  check(mass.rows(), mass.cols(), velocity);
  if (mass.info() != Eigen::Success) throw std::invalid_argument("mass must be positive definite");
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
  MatrixXd halves;    // L^-1 of the rows, (n, 2c): what mass = L L^T leaves to be done from either side
  MatrixXd response;  // (2c, 2c)
  VectorXd speeds;    // free
  double speed_unit{1.0};
  double impulse_unit{1.0};
};

void set(Contacts& out, const MassFactor& mass, const CoordinateVector& velocity, std::span<const Contact> list) {
  const auto count = static_cast<Eigen::Index>(list.size());
  out.halves.resize(velocity.size(), 2 * count);
  out.speeds.resize(2 * count);
  for (int i = 0; i < count; ++i) {
    out.halves.col(i) = list[i].normal;
    out.halves.col(count + i) = list[i].tangent;
    out.speeds[i] = list[i].normal.dot(velocity);
    out.speeds[count + i] = list[i].tangent.dot(velocity);
  }
  for (int i = 0; i < 2 * count; ++i) solve_lower(mass.matrixLLT(), out.halves.col(i));
  out.response.noalias() = out.halves.transpose().lazyProduct(out.halves);
  if (!out.response.allFinite() || !out.speeds.allFinite())
    throw std::invalid_argument("mass, velocities and contacts must be finite");
  const double speed = out.speeds.cwiseAbs().maxCoeff();
  const double response = out.response.diagonal().mean();
  out.speed_unit = speed > 0.0 ? speed : 1.0;
  out.impulse_unit = response > 0.0 ? out.speed_unit / response : 1.0;
  out.speeds /= out.speed_unit;
  out.response *= out.impulse_unit / out.speed_unit;
}

// Unknowns: normal impulses n; b and c, by which friction pushes along +tangent with against * b and along -tangent
// with along * c, b + c <= n; s, which is what slides, times its coefficient. With the coefficients in the columns and
// not in the bounds the matrix is copositive, so that Lemke's method finds an answer if there is one, and zero is
// allowed.
struct Unknowns {
  // Each of n, b and c moves one impulse: `impulse[i]`, by `share[i]` of what it is.
  std::vector<int> impulse;  // (3c)
  VectorXd share;            // (3c)
  MatrixXd matrix;           // (4c, 4c)
  VectorXd constant;         // (4c)

  [[nodiscard]] VectorXd impulses_by(const VectorXd& found) const {
    VectorXd out = VectorXd::Zero(2 * share.size() / 3);
    for (int i = 0; i < share.size(); ++i) out[impulse[i]] += share[i] * found[i];
    return out;
  }
};

void set(Unknowns& out, const Contacts& contacts, std::span<const Contact> list) {
  const int count = static_cast<int>(list.size());
  const int pushes = 3 * count;
  out.impulse.resize(static_cast<std::size_t>(pushes));
  out.share.resize(pushes);
  const auto unknowns = 4 * static_cast<Eigen::Index>(list.size());
  out.matrix.setZero(unknowns, unknowns);
  out.constant.setZero(unknowns);
  for (int i = 0; i < count; ++i) {
    out.impulse[i] = i;
    out.impulse[count + i] = out.impulse[2 * count + i] = count + i;
    out.share[i] = 1.0;
    out.share[count + i] = list[i].friction.against;
    out.share[2 * count + i] = -list[i].friction.along;
    out.matrix(count + i, pushes + i) = 1.0;
    out.matrix(2 * count + i, pushes + i) = 1.0;
    out.matrix(pushes + i, i) = 1.0;
    out.matrix(pushes + i, count + i) = -1.0;
    out.matrix(pushes + i, 2 * count + i) = -1.0;
  }
  for (int k = 0; k < pushes; ++k) {
    for (int i = 0; i < pushes; ++i)
      out.matrix(i, k) = out.share[i] * contacts.response(out.impulse[i], out.impulse[k]) * out.share[k];
    out.constant[k] = out.share[k] * contacts.speeds[out.impulse[k]];
  }
}

// Kept from call to call for its memory alone: a step has as many contacts as the step before, nearly always.
struct Workspace {
  Contacts contacts;
  Unknowns unknowns;
};

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
  VectorXd impulses = unknowns.impulses_by(found);
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
  if (rows.empty()) return impulses;  // all are open
  const int size = static_cast<int>(rows.size());
  const MatrixXd ways = freedom.leftCols(size);
  const VectorXd speeds = contacts.response * impulses + contacts.speeds;
  const MatrixXd response = contacts.response * ways;
  constexpr double same = 1e-9;  // below, two rows are the same
  const VectorXd change = algebra::minimum_norm(response(rows, Eigen::all), -speeds(rows), same);
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
// answers differ by less than this (1.2e-6 between two fingers at a friction of 3). Of 1 m/s it is a hundredth of a
// millimetre a second, and an object counts as slipping from 20 mm/s on.
constexpr double allowed_of_wedged = 1e-5;

// The problem of contacts that give way by `give` times their impulse, less that of `impulses`.
Unknowns giving_way(const Unknowns& rigid, double give, const VectorXd& impulses) {
  Unknowns out = rigid;
  const int pushes = static_cast<int>(rigid.share.size());
  for (int k = 0; k < pushes; ++k) {
    for (int i = 0; i < pushes; ++i)
      if (rigid.impulse[i] == rigid.impulse[k]) out.matrix(i, k) += give * rigid.share[i] * rigid.share[k];
    out.constant[k] -= give * rigid.share[k] * impulses[rigid.impulse[k]];
  }
  return out;
}

std::optional<VectorXd> solved(const Unknowns& rigid, const Attempt& attempt, const VectorXd& impulses) {
  if (attempt.give == 0.0) return lemke(rigid.matrix, rigid.constant, attempt.tolerances);
  const Unknowns giving = giving_way(rigid, attempt.give, impulses);
  return lemke(giving.matrix, giving.constant, attempt.tolerances);
}

void attempt_impulses(const Attempt& attempt, const Contacts& contacts, const Unknowns& rigid,
                      std::span<const Contact> list, BestImpulses& best) {
  VectorXd impulses = VectorXd::Zero(contacts.speeds.size());
  for (int round = 0; round < attempt.rounds; ++round) {
    const std::optional<VectorXd> found = solved(rigid, attempt, impulses);
    if (!found) return;
    impulses = rigid.impulses_by(*found);
    best.consider(impulses);
    if (best.fault() < 0.1 * allowed) return;
    best.consider(refined(contacts, list, rigid, *found));
    if (best.fault() < allowed) return;
  }
}

VectorXd impulses_of(const Contacts& contacts, const Unknowns& unknowns, std::span<const Contact> list) {
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
  check(mass.rows(), mass.cols(), free_velocity);
  return contact_impulses(MassFactor(mass), free_velocity, contacts);
}

ContactStep contact_impulses(const MassFactor& mass, const CoordinateVector& free_velocity,
                             std::span<const Contact> contacts) {
  check(mass, free_velocity, contacts);
  ContactStep out{free_velocity, std::vector<ContactImpulse>(contacts.size())};
  if (contacts.empty()) return out;
  thread_local Workspace work;
  set(work.contacts, mass, free_velocity, contacts);
  set(work.unknowns, work.contacts, contacts);
  const VectorXd impulses = work.contacts.impulse_unit * impulses_of(work.contacts, work.unknowns, contacts);
  CoordinateVector change = work.contacts.halves.lazyProduct(impulses);
  solve_upper(mass.matrixLLT(), change);
  out.velocities += change;
  const int count = static_cast<int>(contacts.size());
  for (int i = 0; i < count; ++i)
    out.impulses[i] = {.normal = impulses[i],
                       .tangential = impulses[count + i],
                       .normal_speed = contacts[i].normal.dot(out.velocities),
                       .sliding_speed = contacts[i].tangent.dot(out.velocities)};
  return out;
}

}  // namespace coilwright::mechanics
