#include "measurement/planning/smallest_strength.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/identification/effect_strength.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Effect;
using actuator::EffectKind;

// Quantile of the normal distribution that leaves 80 % above: the length that is measured scatters by one.
constexpr double quantile_80 = 0.8416;
constexpr double close_enough = 0.05;
constexpr int most_steps = 18;
// A start is scaled by at most this. Beyond, an effect without a bound is another rig.
constexpr double strongest = 1e4;
constexpr double widest_step = 30.0;

// One strength that was tried.
struct Tried {
  double share{};
  double over_limit{};  // NaN: the motion cannot be simulated
  Effect effect{};
  Eigen::VectorXd change{};
  [[nodiscard]] bool simulated() const { return !std::isnan(over_limit); }
};

class Scaling {
 public:
  Scaling(const LinearisedRecords& records, Effect start, double limit)
      : records_(records), start_(std::move(start)), limit_(limit) {}

  [[nodiscard]] Tried at(double share) {
    Tried out{.share = share,
              .over_limit = std::numeric_limits<double>::quiet_NaN(),
              .effect = identification::at_share_of_strength(start_, share)};
    auto change = records_.change_by(out.effect);
    if (!change || !change->allFinite()) return out;
    out.over_limit = records_.beyond_declared(*change).norm() / limit_;
    if (refits_ && out.over_limit > 0.5) refit(out, *change);
    out.change = std::move(*change);
    return out;
  }

  // From here on declared numbers are fitted to each change, and not only along their tangents: where these promise
  // that the effect is found. The same strength, judged so.
  [[nodiscard]] Tried judged_by_refits(Tried tried) {
    refits_ = true;
    refit(tried, tried.change);
    return tried;
  }
  [[nodiscard]] bool refits() const { return refits_; }

  [[nodiscard]] bool at_bound(double share) const {
    return identification::at_share_of_strength(start_, share).values ==
           identification::at_share_of_strength(start_, share * 1.01).values;
  }

 private:
  void refit(Tried& tried, const Eigen::VectorXd& change) {
    tried.over_limit = std::min(tried.over_limit, records_.length_after_refit(change) / limit_);
  }

  const LinearisedRecords& records_;
  Effect start_;
  double limit_;
  bool refits_ = false;
};

// Between a strength that is not found and one that is (or that cannot be simulated): where the length, a power of the
// strength, meets the limit.
double between(const Tried& below, const Tried& above) {
  const double middle = std::sqrt(below.share * above.share);
  if (!above.simulated() || below.over_limit <= 0.0) return middle;
  const double power = std::log(above.over_limit / below.over_limit);
  if (power <= 0.0) return middle;
  const double place = std::clamp(-std::log(below.over_limit) / power, 0.1, 0.9);
  return below.share * std::pow(above.share / below.share, place);
}

SmallestStrength result_of(Tried tried, bool visible, std::string remark) {
  return {.effect = std::move(tried.effect),
          .change = std::move(tried.change),
          .over_limit = tried.simulated() ? tried.over_limit : 0.0,
          .visible = visible,
          .remark = std::move(remark)};
}

// From `now` on, whose strength is that of a start.
SmallestStrength scale_to_limit(Scaling& scaling, Tried now) {
  std::optional<Tried> below;
  std::optional<Tried> above;
  std::string remark = "changes too little at any strength that was tried";
  for (int step = 0; step < most_steps; ++step) {
    const auto is_at_limit = [&] { return now.simulated() && std::abs(now.over_limit - 1.0) <= close_enough; };
    if (is_at_limit() && !scaling.refits()) {
      now = scaling.judged_by_refits(std::move(now));
      if (above && above->simulated()) above.reset();  // judged along tangents
    }
    if (is_at_limit()) return result_of(std::move(now), true, "");
    const bool is_below = now.simulated() && now.over_limit < 1.0;
    (is_below ? below : above) = now;
    double next = 0.0;
    if (below && above) {
      if (above->share / below->share < 1.0 + close_enough) break;
      next = between(*below, *above);
    } else if (below) {
      if (scaling.at_bound(below->share)) {
        remark = "would not be found even at its physical bound";
        break;
      }
      if (below->share >= strongest) break;
      next = std::min(strongest, below->share * std::clamp(1.0 / std::max(below->over_limit, 1e-9), 1.1, widest_step));
    } else {
      next = above->simulated() ? above->share / std::clamp(above->over_limit, 1.1, widest_step) : 0.1 * above->share;
    }
    now = scaling.at(next);
  }
  if (above && above->simulated()) return result_of(std::move(*above), true, "");
  if (below && above) remark = "the motion leaves the model before it would be found";
  if (!below) return result_of(std::move(*above), false, "the motion leaves the model");
  return result_of(std::move(*below), false, std::move(remark));
}

// The start whose smallest strength is likely to be the smallest.
double predicted(const Tried& tried, const std::optional<std::size_t>& main) {
  if (!tried.simulated() || tried.over_limit <= 0.0) return std::numeric_limits<double>::infinity();
  if (!main) return 1.0 / tried.over_limit;
  const double absent = *tried.effect.kind->parameters()[*main].absent;
  const double value = tried.effect.values[*main];
  const double strength = std::isinf(absent) ? 1.0 / std::max(1e-12, std::abs(value)) : std::abs(value - absent);
  return strength / tried.over_limit;
}

}  // namespace

double DetectionLimit::length(Eigen::Index more_numbers) const {
  const double penalty = std::log(std::max(std::exp(1.0), samples / overdispersion));
  const double fall = identification::decision_thresholds.decisive_gain + static_cast<double>(more_numbers) * penalty;
  return std::sqrt(overdispersion) * (std::sqrt(std::max(0.0, fall)) + quantile_80);
}

std::optional<std::size_t> main_number(const EffectKind& kind) {
  const auto numbers = kind.parameters();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i].absent && numbers[i].choices.empty()) return i;
  return std::nullopt;
}

SmallestStrength smallest_strength(const LinearisedRecords& records, const EffectKind& kind,
                                   const actuator::RigScale& scale, const DetectionLimit& limit) {
  const auto main = main_number(kind);
  std::optional<Scaling> best_scaling;
  std::optional<Tried> best;
  for (std::vector<double>& values : kind.starts(scale)) {
    Effect start{.kind = &kind, .values = std::move(values)};
    Scaling scaling(records, start, limit.length(records.numbers_of(start)));
    Tried tried = scaling.at(1.0);
    if (best && !(predicted(tried, main) < predicted(*best, main))) continue;
    best = std::move(tried);
    best_scaling.emplace(records, std::move(start), limit.length(records.numbers_of(best->effect)));
  }
  if (!main) {
    const bool visible = best->simulated() && best->over_limit >= 1.0;
    return result_of(std::move(*best), visible, visible ? "" : "changes too little");
  }
  return scale_to_limit(*best_scaling, std::move(*best));
}

}  // namespace coilwright::measurement::planning
