#include "measurement/correction/find_correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "measurement/correction/correction_picture.hpp"
#include "measurement/correction/held_out.hpp"
#include "measurement/correction/linear_gain.hpp"
#include "measurement/correction/rest_after_release.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::correction {
namespace {

using identification::FittedHypothesis;

// Of runs left out in turn, the mean share of the squared residual above the noise that a correction must take away
// from every model that stands without it.
constexpr double least_gain = 0.35;
// A promise of less is not followed.
constexpr double least_promise = 0.02;
// How many corrections are fitted altogether. With the slopes and the refits without some runs that is about 3700
// simulations of a run for a set of ten.
constexpr std::size_t most_fits = 2;
// And a second one only if it promises this share of the best one's.
constexpr double near_best = 0.75;
// A correction that is nearly right is as good as one that is quite: its prior is a convention.
constexpr fit::FitEffort effort{.iterations = 8, .tolerance = 5e-3};

// The angle alone finely, for torques that alternate over it; pairs of variables more coarsely.
std::vector<CorrectionShape> shapes(bool has_coils) {
  using enum actuator::CorrectionVariable;
  std::vector<CorrectionShape> out{
      {.variables = {{angle, 25, 0.06}}, .most_directions = 18},
      {.variables = {{angle, 9, 0.2}, {rate, 7, 0.25}}, .most_directions = 16},
  };
  if (has_coils) {
    out.push_back({.variables = {{angle, 9, 0.2}, {current, 5, 0.4}}, .most_directions = 16});
    out.push_back({.variables = {{rate, 7, 0.25}, {current, 5, 0.4}}, .most_directions = 14});
  }
  return out;
}

// A model without a correction, and how it predicts runs that were left out.
struct Base {
  const FittedHypothesis* model{};
  std::vector<double> held_out{};
};

// A correction that has not been fitted yet.
struct Candidate {
  std::shared_ptr<const CorrectionKind> kind{};
  LinearGain promise{};
};

// A correction that has.
struct Fitted {
  std::shared_ptr<const CorrectionKind> kind{};
  FittedHypothesis hypothesis;
  double gain{};  // over the best of all bases
};

// Corrections of one base.
class Search {
 public:
  Search(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base, double torque)
      : runs_(runs), base_(base), torque_(torque) {}

  // The shapes that promise most, best first.
  [[nodiscard]] std::vector<Candidate> candidates(const std::vector<CorrectionShape>& shapes,
                                                  std::span<const JointSample> samples, std::size_t most) {
    std::vector<Candidate> out;
    for (const CorrectionShape& shape : shapes)
      if (auto found = candidate(shape, samples)) out.push_back(std::move(*found));
    std::ranges::stable_sort(out, std::greater(), [](const Candidate& each) { return each.promise.fall; });
    if (out.size() > most) out.resize(most);
    std::erase_if(out, [best = out.empty() ? 0.0 : out.front().promise.fall](const Candidate& each) {
      return each.promise.fall < near_best * best;
    });
    return out;
  }

  [[nodiscard]] std::optional<FittedHypothesis> fitted(const Candidate& candidate) {
    identification::PlannedFit plan = with(*candidate.kind);
    plan.start = start_of(plan, candidate.promise.step);
    fit::FitRequest asked = request(plan);
    asked.effort = effort;
    asked.updates_derivatives = true;
    auto found = fit::fit(asked);
    if (!found) return std::nullopt;
    return identification::score(runs_, plan.hypothesis, std::move(*found));
  }

 private:
  [[nodiscard]] std::optional<Candidate> candidate(const CorrectionShape& shape, std::span<const JointSample> samples) {
    auto basis = correction_basis(shape, samples);
    if (!basis) return std::nullopt;
    const CorrectionKind kind(*basis, torque_, 1.0);
    const identification::PlannedFit plan = with(kind);
    const auto at_zero = fit::evaluate_with_jacobian(request(plan));
    if (!at_zero) return std::nullopt;
    LinearGain promise = linear_gain(plan.hypothesis, *at_zero, basis->size());
    if (!(promise.fall > least_promise * base_.chi_square_above_noise())) return std::nullopt;
    auto chosen = std::make_shared<const CorrectionKind>(std::move(*basis), torque_, promise.deviation);
    return Candidate{.kind = std::move(chosen), .promise = std::move(promise)};
  }
  [[nodiscard]] identification::PlannedFit with(const CorrectionKind& kind) const {
    const actuator::Effect none = kind.none();
    return identification::with_added_effects(base_, std::span(&none, 1));
  }
  [[nodiscard]] fit::FitRequest request(const identification::PlannedFit& plan) const {
    return {.hypothesis = &plan.hypothesis,
            .runs = runs_,
            .start = plan.start,
            .local_numbers_from = &base_.fit,
            .derivatives_from = &base_.fit};
  }
  // As far along the step as the squared residual falls.
  [[nodiscard]] Eigen::VectorXd start_of(const identification::PlannedFit& plan, const Eigen::VectorXd& step) {
    for (const double share : {1.0, 0.5, 0.2}) {
      identification::PlannedFit there = plan;
      there.start = plan.hypothesis.clamped(plan.start + share * step);
      const auto found = fit::evaluate_at(request(there));
      if (found && found->objective() < base_.fit.objective()) return there.start;
    }
    return plan.start;
  }

  std::span<const replay::PreparedRun> runs_;
  const FittedHypothesis& base_;
  double torque_;
};

// Why there can be none, whatever the data say.
std::string impossible(std::span<const replay::PreparedRun> runs, const actuator::ModelSpec& spec,
                       const std::optional<localise::ResidualTorque>& residual) {
  if (spec.torque_correction) return "The declared actuator has a nameless correction already.";
  if (!residual || !(residual->rms > 0.0)) return "No motion is long enough to show a torque.";
  if (std::ranges::count_if(runs, &replay::PreparedRun::is_motion) < 2)
    return "With a single motion nothing could show that a correction holds elsewhere.";
  return {};
}

}  // namespace

FoundCorrection find_correction(std::span<const replay::PreparedRun> runs,
                                const identification::Attribution& attribution,
                                const std::optional<localise::ResidualTorque>& residual,
                                const std::function<void(const std::string&)>& progress) {
  FoundCorrection out;
  const FittedHypothesis& after = attribution.after;
  const actuator::ModelSpec spec = after.hypothesis.spec_at(after.fit.values);
  out.outcome.reason = impossible(runs, spec, residual);
  if (!out.outcome.reason.empty()) return out;

  // Effects that explain a part may be in the way of a correction that explains the whole.
  std::vector<Base> bases{{.model = &after}};
  if (attribution.has_effects()) bases.push_back({.model = &attribution.before});
  for (Base& base : bases) base.held_out = held_out_squares(runs, *base.model);
  const VisitedStates visited = visited_states(runs, after);
  std::vector<Fitted> found;
  std::size_t tried = 0;
  for (const Base& base : bases) {
    Search search(runs, *base.model, residual->rms);
    for (const Candidate& candidate :
         search.candidates(shapes(spec.coils > 0), visited.samples, most_fits / bases.size())) {
      if (progress) progress(fmt::format("torque without a name: fit {} of at most {}", ++tried, most_fits));
      auto fitted = search.fitted(candidate);
      if (!fitted) continue;
      const auto held_out = held_out_squares(runs, *fitted);
      double gain = 1.0;
      for (const Base& other : bases) gain = std::min(gain, mean_gain(runs, other.held_out, held_out));
      found.push_back({.kind = candidate.kind, .hypothesis = std::move(*fitted), .gain = gain});
    }
  }
  std::ranges::stable_sort(found, std::greater(), &Fitted::gain);
  const actuator::Model without(spec);
  out.outcome.reason =
      "No smooth torque over angle, rate or current predicts runs that were left out in turn clearly better.";
  for (Fitted& best : found) {
    if (!(best.gain >= least_gain)) break;
    if (!comes_to_rest(best.hypothesis.hypothesis.model_at(best.hypothesis.fit.values), without, visited)) {
      out.outcome.reason = "The best smooth torque would keep a motion going by itself.";
      continue;
    }
    out.outcome.reason.clear();
    out.outcome.found = described({.base = after,
                                   .corrected = best.hypothesis,
                                   .kind = *best.kind,
                                   .samples = visited.samples,
                                   .cross_validated_gain = best.gain});
    out.kind = best.kind;
    out.fitted = std::move(best.hypothesis);
    break;
  }
  return out;
}

}  // namespace coilwright::measurement::correction
