#include "measurement/identification/joint_screening.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <utility>

#include "measurement/identification/effect_strength.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::EffectKind;

constexpr std::size_t largest = 3;

struct Combination {
  std::array<std::size_t, largest> members{};  // of the candidates, ascending; the first `size` of them
  std::array<double, largest> shares{};        // of the guesses
  double fall{};
};

// All candidates with their directions' products: what any combination of them predicts follows from these alone.
class Candidates {
 public:
  Candidates(const FittedHypothesis& base, std::span<const ScreenedEffect> screened) {
    for (const ScreenedEffect& each : screened)
      if (each.residual_direction.size() > 0 && each.residual_direction.squaredNorm() > 0.0) all_.push_back(&each);
    const auto n = static_cast<Eigen::Index>(all_.size());
    const Eigen::Index rows = base.fit.stacked_residuals.size();
    Eigen::MatrixXd directions(rows, n);
    lengths_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::VectorXd& direction = all_[static_cast<std::size_t>(i)]->residual_direction;
      lengths_[i] = direction.norm();
      directions.col(i) = direction / lengths_[i];
    }
    cosines_ = directions.transpose() * directions;
    along_ = -directions.transpose() * base.fit.stacked_residuals;
  }

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] const ScreenedEffect& operator[](std::size_t i) const { return *all_[i]; }
  [[nodiscard]] const EffectKind* kind(std::size_t i) const { return all_[i]->guess.kind; }

  // Adds the combination to `to` if it predicts anything.
  template <int size>
  void consider(const std::array<std::size_t, largest>& members, std::vector<Combination>& to) const {
    Eigen::Matrix<double, size, size> products;
    Eigen::Matrix<double, size, 1> along;
    for (int i = 0; i < size; ++i) {
      along[i] = along_[at(members, i)];
      for (int k = 0; k < size; ++k) products(i, k) = cosines_(at(members, i), at(members, k));
    }
    // Of unit vectors: the squared volume that they span.
    if (products.determinant() <= search_effort.smallest_determinant) return;
    const Eigen::Matrix<double, size, 1> shares = products.inverse() * along;
    Combination found{.members = members, .fall = shares.dot(along)};
    for (int i = 0; i < size; ++i) {
      if (shares[i] < 0.0 && !may_be_negative(*kind(static_cast<std::size_t>(at(members, i))))) return;
      found.shares[static_cast<std::size_t>(i)] = shares[i] / lengths_[at(members, i)];
    }
    if (found.fall > 0.0) to.push_back(found);
  }

 private:
  static Eigen::Index at(const std::array<std::size_t, largest>& members, int i) {
    return static_cast<Eigen::Index>(members[static_cast<std::size_t>(i)]);
  }

  std::vector<const ScreenedEffect*> all_;
  Eigen::VectorXd lengths_, along_;
  Eigen::MatrixXd cosines_;
};

std::vector<Combination> pairs_of(const Candidates& from) {
  std::vector<Combination> out;
  for (std::size_t i = 0; i < from.size(); ++i)
    for (std::size_t k = i + 1; k < from.size(); ++k)
      if (from.kind(i) != from.kind(k)) from.consider<2>({i, k}, out);
  return out;
}

std::vector<Combination> triples_of(const Candidates& from) {
  std::vector<Combination> out;
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t k = i + 1; k < from.size(); ++k) {
      if (from.kind(i) == from.kind(k)) continue;
      for (std::size_t l = k + 1; l < from.size(); ++l)
        if (from.kind(l) != from.kind(i) && from.kind(l) != from.kind(k)) from.consider<3>({i, k, l}, out);
    }
  }
  return out;
}

}  // namespace

std::vector<ScreenedCombination> combinations_by_predicted_fall(const FittedHypothesis& base,
                                                                std::span<const ScreenedEffect> screened,
                                                                std::size_t size, std::size_t count) {
  const Candidates candidates(base, screened);
  std::vector<Combination> all = size == 2 ? pairs_of(candidates) : triples_of(candidates);
  std::ranges::stable_sort(all, [](const Combination& a, const Combination& b) { return a.fall > b.fall; });
  std::vector<ScreenedCombination> out;
  std::vector<std::vector<const EffectKind*>> taken;
  for (const Combination& each : all) {
    if (out.size() == count) break;
    std::vector<const EffectKind*> kinds;
    for (std::size_t i = 0; i < size; ++i) kinds.push_back(candidates.kind(each.members[i]));
    std::ranges::sort(kinds);
    if (std::ranges::find(taken, kinds) != taken.end()) continue;
    taken.push_back(std::move(kinds));
    ScreenedCombination& next = out.emplace_back(ScreenedCombination{.predicted_chi_square_fall = each.fall});
    for (std::size_t i = 0; i < size; ++i)
      next.effects.push_back(at_predicted_strength(candidates[each.members[i]].guess, each.shares[i]));
  }
  return out;
}

}  // namespace coilwright::measurement::identification
