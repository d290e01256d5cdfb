#include "sizing/search/surrogate_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "sizing/nlopt/problem_optimisation.hpp"
#include "sizing/sampling/neighbours.hpp"
#include "sizing/search/exploration.hpp"
#include "sizing/search/source_gains.hpp"
#include "sizing/surrogate/expected_gain.hpp"
#include "sizing/surrogate/infill.hpp"
#include "sizing/surrogate/planner.hpp"

namespace coilwright::sizing {
namespace {

// Designs in a round. A power of two for the Sobol sequence; small enough to learn often, large enough for 16 threads.
constexpr std::size_t largest_round = 16;
// With one objective there is one place to improve, and of a new front little is known: learning sooner is worth more
// than designs evaluated together.
constexpr std::size_t small_round = 8;
constexpr std::size_t rounds_between_descents = 4;
constexpr std::size_t designs_enumerated_together = 1024;
// Where the budget covers every design, so many are found by models before the others are listed: whoever interrupts a
// long list then has what a search of that length finds, and not the best of a corner of the grid.
constexpr std::size_t searched_before_a_list = 1024;
// The search of an end of a front is over after so many designs for each variable without a gain of this part of what
// it has gained in all.
constexpr std::size_t patience_per_variable = 16;
constexpr std::size_t least_patience = 32;
constexpr double least_gain = 1e-3;
// The first designs of a front with limits are those of which a model of all expects most, of so many that evolution
// proposes in a round of so many. Later the front has gaps enough for a local model each.
constexpr std::size_t chosen_by_expected_gain = 300;
constexpr std::size_t candidates_for_choice = 200;
constexpr double bred_candidates = 0.9;

class SurrogateSearch {
 public:
  /// `patience`: so many designs without a gain end the search of an end of a front; nothing: any other search.
  explicit SurrogateSearch(const SearchContext& context, std::optional<std::size_t> patience = std::nullopt)
      : context_{context},
        patience_{patience},
        samples_{context.samples},
        space_{samples_.space()},
        random_{context.options.seed ^ 0x5DEECE66DULL},
        exploration_{samples_, context.options.seed, random_},
        planner_{samples_, random_} {}

  StopReason run();

 private:
  [[nodiscard]] std::size_t round_size() const {
    return samples_.objective_count() == 1 || chooses() ? small_round : largest_round;
  }
  [[nodiscard]] std::size_t left() const { return context_.budget - made_; }
  [[nodiscard]] bool is_of_end() const { return patience_.has_value(); }
  [[nodiscard]] bool stopped() const { return context_.options.stop.stop_requested(); }
  [[nodiscard]] bool goes_on() const {
    return left() > 0 && !stopped() && !exploration_.exhausted() && !(patience_ && made_ - gained_at_ >= *patience_);
  }
  [[nodiscard]] bool has_levels() const { return space_.has_grid() || space_.combinations() > 1; }
  [[nodiscard]] bool has_limited_front() const;
  [[nodiscard]] bool chooses() const;
  [[nodiscard]] std::string_view proposer(ProposalSource source) const;
  void evaluate(const ProposalBatch& batch);
  void enumerate();
  void search_ends();
  void search_rounds();
  void look_for_gain();
  void evaluate_initial_designs();
  void round();
  void round_of_choice();
  void round_of_models(const std::vector<SubproblemTask>& tasks);
  void round_on_problem(const std::vector<SubproblemTask>& tasks, Algorithm algorithm);
  void descend(const std::vector<SubproblemTask>& tasks);
  [[nodiscard]] ProposalBatch proposals_of_models(const std::vector<SubproblemTask>& tasks);
  [[nodiscard]] std::vector<UnitPoint> neighbours_of_best(const std::vector<SubproblemTask>& tasks) const;

  const SearchContext& context_;
  std::optional<std::size_t> patience_;
  Samples& samples_;
  const DesignSpace& space_;
  std::mt19937_64 random_;
  Exploration exploration_;
  Planner planner_;
  SourceGains gains_;
  std::size_t known_before_ = context_.archive.size();
  std::size_t made_ = 0;
  std::size_t gained_at_ = 0;      // designs made when the best one last improved
  std::optional<double> first_{};  // best value when one was first known
  double best_ = std::numeric_limits<double>::infinity();
  std::size_t rounds_ = 0;
  bool choosing_ = false;  // the round is one of choice
};

// The words of evaluations.csv.
std::string_view SurrogateSearch::proposer(ProposalSource source) const {
  if (is_of_end()) return "end";
  if (choosing_) return "expected_gain";
  switch (source) {
    case ProposalSource::gap:
      return "gap";
    case ProposalSource::anchor:
      if (samples_.feasible_count() == 0) return "feasibility";
      return samples_.objective_count() > 1 ? "end" : "model";
    case ProposalSource::niche:
      return "level";
    case ProposalSource::evolution:
      return "evolution";
    case ProposalSource::sobol:
      return "spread";
  }
  return {};
}

void SurrogateSearch::evaluate(const ProposalBatch& batch) {
  const std::vector<Proposal>& proposals = batch.proposals();
  std::vector<std::vector<double>> points;
  for (std::size_t i = 0; i < std::min(proposals.size(), left()); ++i) {
    points.push_back(space_.point(proposals[i].point.unit, proposals[i].point.combination));
  }
  const std::vector<Record> records = context_.workers.evaluate(
      context_.archive, points, context_.options.stop, [&](std::size_t i) { return proposer(proposals[i].source); });
  std::vector<double> gains;
  for (const Record& record : records) gains.push_back(samples_.add(record));
  for (std::size_t i = 0; i < records.size(); ++i) exploration_.learn(proposals[i], samples_.as_sample(records[i]));
  made_ = context_.archive.size() - known_before_;
  gains_.learn(proposals, gains);
  for (std::size_t i = 0; i < gains.size(); ++i) {
    if (proposals[i].source == ProposalSource::anchor) planner_.count_anchor(proposals[i].index, gains[i]);
  }
  report_progress(context_);
}

void SurrogateSearch::evaluate_initial_designs() {
  const std::size_t n = space_.dimension();
  const std::uint64_t combinations = std::min<std::uint64_t>(space_.combinations(), 64);
  // More than a simplex for every combination of levels, and at most a fifth of the budget.
  const std::size_t wanted =
      std::min<std::size_t>((2 * n + 4) * combinations, std::max<std::size_t>(context_.budget / 5, 1));
  while (samples_.size() < wanted && goes_on()) {
    const std::size_t size = std::min({wanted - samples_.size(), left(), 4 * round_size()});
    evaluate(exploration_.filled(ProposalBatch{space_}, size, gains_.evolution_share()));
  }
}

// The answer must be the best of its grid neighbourhood. Single steps come first. Where limits couple variables, only
// steps in two variables may be left: one design of a round, or half of a round near the end.
std::vector<UnitPoint> SurrogateSearch::neighbours_of_best(const std::vector<SubproblemTask>& tasks) const {
  const std::size_t best = samples_.front().front();
  const std::size_t half = round_size() / 2;
  std::vector<UnitPoint> neighbours = unknown_neighbours(samples_, best);
  if (!neighbours.empty()) {
    neighbours.resize(std::min(neighbours.size(), half));
    return neighbours;
  }
  const auto anchor = std::ranges::find(tasks, ProposalSource::anchor, &SubproblemTask::source);
  if (anchor == tasks.end()) return {};
  const std::size_t count = left() < context_.budget / 6 ? half : half / 4;
  return least_surprising_neighbours(samples_, anchor->goal, best, count);
}

void SurrogateSearch::round() {
  if (chooses()) return round_of_choice();
  const auto wanted = static_cast<std::size_t>(std::lround(gains_.model_share() * static_cast<double>(round_size())));
  const std::vector<SubproblemTask> tasks = planner_.plan(std::min(wanted, left()), rounds_);
  const Algorithm algorithm = context_.options.algorithm;
  if (algorithm != Algorithm::automatic) return round_on_problem(tasks, algorithm);
  const bool one_objective = samples_.objective_count() == 1;
  if (one_objective && rounds_ % rounds_between_descents == 0 && !space_.has_grid()) descend(tasks);
  round_of_models(tasks);
}

ProposalBatch SurrogateSearch::proposals_of_models(const std::vector<SubproblemTask>& tasks) {
  std::vector<std::vector<UnitPoint>> found(tasks.size());
  context_.workers.run(tasks.size(), [&](std::size_t i) {
    if (!stopped()) found[i] = infill(samples_, tasks[i].goal, tasks[i].region);
  });
  ProposalBatch batch{space_};
  if (samples_.objective_count() == 1 && !samples_.front().empty()) {
    for (UnitPoint& point : neighbours_of_best(tasks))
      batch.add({.point = std::move(point), .source = ProposalSource::evolution, .index = 0});
  }
  for (std::size_t i = 0; i < tasks.size() && batch.size() < round_size(); ++i) {
    const SubproblemTask& task = tasks[i];
    // A failure until shown otherwise: a success replaces the bound.
    if (task.source == ProposalSource::gap) samples_.bounds().count_failure(task.index);
    const bool placed = std::ranges::any_of(found[i], [&](UnitPoint& point) {
      return batch.add({.point = point, .source = task.source, .index = task.index});
    });
    if (!placed && task.source == ProposalSource::anchor) planner_.count_anchor(task.index, 0.0);
  }
  return batch;
}

void SurrogateSearch::round_of_models(const std::vector<SubproblemTask>& tasks) {
  ProposalBatch batch = proposals_of_models(tasks);
  evaluate(exploration_.filled(std::move(batch), std::min(round_size(), left()), gains_.evolution_share()));
  ++rounds_;
}

// Evolution proposes, the model chooses.
void SurrogateSearch::round_of_choice() {
  const std::size_t size = std::min(round_size(), left());
  const ProposalBatch bred = exploration_.filled(ProposalBatch{space_}, candidates_for_choice, bred_candidates);
  std::vector<std::vector<double>> candidates;
  for (const Proposal& proposal : bred.proposals()) candidates.push_back(proposal.point.unit);
  ProposalBatch batch{space_};
  for (const std::size_t i : of_most_expected_gain(samples_, candidates, size)) batch.add(bred.proposals()[i]);
  choosing_ = true;
  evaluate(exploration_.filled(std::move(batch), size, bred_candidates));
  choosing_ = false;
  ++rounds_;
}

// Only without a grid, because a difference over a grid step is no gradient. Models are poor in a narrow curved valley;
// there SLSQP on the problem itself gets further, from the best design and from one other region in turn. This takes a
// third of the evaluations; docs/decisions/0006-search-strategy.md has what it gains.
void SurrogateSearch::descend(const std::vector<SubproblemTask>& tasks) {
  if (tasks.empty()) return;
  const std::size_t other = 1 + rounds_ / rounds_between_descents % tasks.size();
  std::vector<SubproblemTask> two{tasks.front()};
  if (other < tasks.size()) two.push_back(tasks[tasks.size() - other]);
  round_on_problem(two, Algorithm::slsqp);
}

// Pursues the same goals with runs of NLopt on the problem itself.
void SurrogateSearch::round_on_problem(const std::vector<SubproblemTask>& tasks, Algorithm algorithm) {
  const std::size_t n = space_.dimension();
  const std::size_t share = std::max<std::size_t>(left() / std::max<std::size_t>(tasks.size(), 1), 1);
  const std::size_t budget = std::min<std::size_t>(share, 15 * (n + 1));
  std::vector<std::vector<Record>> found(tasks.size());
  const std::uint64_t seed = random_();
  const std::size_t runs = std::min(tasks.size(), left());
  const Box box = whole_box(space_);
  context_.workers.run(runs, [&](std::size_t i) {
    const SubproblemTask& task = tasks[i];
    const Sample& start = samples_[task.region.from];
    found[i] = optimise_on_problem(context_.archive, samples_,
                                   {.algorithm = algorithm,
                                    .goal = task.goal,
                                    .start = {.unit = start.unit, .combination = start.combination},
                                    .box = box,
                                    .budget = budget,
                                    .seed = seed + i},
                                   context_.options.stop);
  });
  for (const SubproblemTask& task : tasks) {
    if (task.source == ProposalSource::gap) samples_.bounds().count_failure(task.index);
    if (task.source == ProposalSource::anchor) planner_.count_anchor(task.index, 0.0);
  }
  for (const std::vector<Record>& records : found) {
    for (const Record& record : records) {
      context_.archive.number(record.point, is_of_end() ? "end" : name_of(algorithm));
      samples_.add(record);
    }
  }
  made_ = context_.archive.size() - known_before_;
  if (left() > 0) {
    const std::size_t size = std::min<std::size_t>(left(), 2);
    evaluate(exploration_.filled(ProposalBatch{space_}, size, gains_.evolution_share()));
  }
  ++rounds_;
}

// Whether the best design, of one objective, has improved by what can be seen.
void SurrogateSearch::look_for_gain() {
  if (samples_.objective_count() > 1 || samples_.front().empty()) return;
  const double best = samples_[samples_.front().front()].values.front();
  if (!first_) first_ = best;
  if (best_ - best <= least_gain * (*first_ - best)) return;
  best_ = best;
  gained_at_ = made_;
}

// Without limits any step from the front is a design, and the local models reach its gaps and its ends sooner.
bool SurrogateSearch::has_limited_front() const {
  return samples_.objective_count() > 1 && samples_.constraint_count() > 0 &&
         context_.options.algorithm == Algorithm::automatic;
}

// One model of all designs has no place for levels, and quantities jump from one grid value to the next.
bool SurrogateSearch::chooses() const {
  return has_limited_front() && !has_levels() && made_ < chosen_by_expected_gain;
}

// On a grid each end of a front is the answer of a search for that objective alone. Steps towards gaps of the front do
// not reach it where limits couple variables: the front then is a point in a thin set, and its gaps are as small as
// itself.
void SurrogateSearch::search_ends() {
  const std::size_t objectives = samples_.objective_count();
  const std::size_t patience = std::max(least_patience, space_.dimension() * patience_per_variable);
  const std::size_t share = context_.budget / (objectives + 1);
  for (std::size_t objective = 0; objective < objectives && goes_on(); ++objective) {
    Samples alone{samples_, objective};
    const std::size_t known = alone.size();
    SearchOptions options = context_.options;
    options.seed += objective + 1;  // other designs than those of the front and of the other ends
    const SearchContext context{.archive = context_.archive,
                                .samples = alone,
                                .workers = context_.workers,
                                .options = options,
                                .budget = std::min(left(), share)};
    SurrogateSearch{context, patience}.search_rounds();
    for (std::size_t i = known; i < alone.size(); ++i)
      samples_.add({.point = alone[i].point, .evaluation = *context_.archive.find(alone[i].point)});
    made_ = context_.archive.size() - known_before_;
  }
}

void SurrogateSearch::search_rounds() {
  evaluate_initial_designs();
  while (goes_on()) {
    round();
    look_for_gain();
  }
}

void SurrogateSearch::enumerate() {
  while (left() > 0 && !stopped()) {
    const ProposalBatch batch = exploration_.next_of_grid(std::min(left(), designs_enumerated_together));
    if (batch.size() == 0) return;
    evaluate(batch);
  }
}

StopReason SurrogateSearch::run() {
  const std::uint64_t designs = space_.design_count();
  const bool lists_all = designs > 0 && designs <= context_.budget + samples_.size();
  if (!lists_all || designs > searched_before_a_list) {
    evaluate_initial_designs();
    if (has_limited_front() && has_levels() && !lists_all) search_ends();
    while (goes_on() && (!lists_all || made_ < searched_before_a_list)) round();
  }
  if (lists_all) enumerate();
  if (stopped()) return StopReason::interrupted;
  const bool all = designs > 0 && samples_.size() == designs;
  return all || exploration_.exhausted() ? StopReason::space_exhausted : StopReason::evaluation_limit;
}

}  // namespace

StopReason surrogate_search(const SearchContext& context) {
  return SurrogateSearch{context}.run();
}

}  // namespace coilwright::sizing
