#include "sizing/engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

#include "sizing/direct.hpp"
#include "sizing/explorer.hpp"
#include "sizing/infill.hpp"
#include "sizing/neighbours.hpp"
#include "sizing/random.hpp"

namespace coilwright::sizing {
namespace {

// Designs per round. A power of two for the Sobol sequence; small enough to learn often, large enough for 16 threads.
constexpr std::size_t largest_round = 16;
// One objective means one place to improve: learning sooner is worth more than company.
constexpr std::size_t round_of_one_objective = 8;
constexpr std::size_t rounds_between_descents = 4;

enum class Way : std::size_t { gap, anchor, breed, scatter };
constexpr std::size_t ways = 4;

// A model task: a goal, where to look, and whom to tell.
struct Attempt {
  Goal goal;
  Region region{};
  Way way{};
  std::size_t which{};  // bound of a gap, objective of an anchor
};

struct Proposal {
  Candidate candidate;
  Way way{};
  std::size_t which{};
};

// Nodes of a model after a failure stand this far apart: other scales in turn, up to the whole space.
double apart(int failures) {
  constexpr std::array<double, 5> distances{0.0, 0.03, 0.1, 0.01, 0.3};
  return distances[static_cast<std::size_t>(failures) % distances.size()];
}

class Engine {
 public:
  explicit Engine(const EngineRun& run)
      : run_{run},
        samples_{run.samples},
        space_{samples_.space()},
        explorer_{space_, run.options.seed},
        random_{run.options.seed ^ 0x5DEECE66DULL},
        anchor_failures_(samples_.objective_count(), 0) {}

  StopReason run();

 private:
  [[nodiscard]] std::size_t round_size() const {
    return samples_.objective_count() == 1 ? round_of_one_objective : largest_round;
  }
  [[nodiscard]] std::size_t left() const { return run_.budget - made_; }
  void evaluate(std::vector<Proposal> proposals);
  void initial_design();
  void round();
  void direct_round(const std::vector<Attempt>& list, Algorithm algorithm);
  void descend(const std::vector<Attempt>& list);
  [[nodiscard]] std::vector<Attempt> attempts(std::size_t wanted);
  void add_gap_attempts(std::vector<Attempt>& list, std::size_t wanted);
  [[nodiscard]] double single_span() const;
  void add_anchor_attempts(std::vector<Attempt>& list, std::size_t wanted);
  void add_feasibility_attempts(std::vector<Attempt>& list, std::size_t wanted);
  [[nodiscard]] Region gap_region(const Goal& goal, const UpperBound& bound);
  [[nodiscard]] std::vector<std::size_t> best_apart(const Goal& goal, std::size_t count, std::uint64_t combination,
                                                    bool any_combination) const;
  [[nodiscard]] std::vector<std::size_t> parents() const;
  void explore(std::vector<Proposal>& batch, std::size_t size);
  void credit(const std::vector<double>& gains, const std::vector<Proposal>& batch);

  const EngineRun& run_;
  Samples& samples_;
  const DesignSpace& space_;
  Explorer explorer_;
  std::mt19937_64 random_;
  std::size_t known_before_ = run_.archive.size();
  std::size_t made_ = 0;
  std::size_t rounds_ = 0, anchor_turn_ = 0;
  bool exhausted_ = false;
  std::vector<int> anchor_failures_;
  std::array<double, ways> earned_{1, 1, 1, 1};
};

// Normalised distance below the reference the front has so far; gaps are boxes in this frame.
double reference_of(const FrontFrame& frame, std::size_t i) {
  return frame.nadir[i] + 0.1 * (frame.nadir[i] - frame.ideal[i]);
}

// The box below an upper bound in which points are not dominated by its neighbours; nothing if it has no volume.
struct Gap {
  Objectives origin, span;
  double volume = 1;
};

Gap gap_below(const Samples& samples, const UpperBound& bound) {
  const FrontFrame& frame = samples.frame();
  Gap gap;
  for (std::size_t i = 0; i < bound.corner.size(); ++i) {
    double low = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < bound.definers.size(); ++k) {
      if (k != i && bound.definers[k] != UpperBound::none) low = std::min(low, samples[bound.definers[k]].values[i]);
    }
    low = std::max(low, frame.ideal[i]);
    if (!std::isfinite(low)) low = frame.ideal[i];
    const double high = std::min(bound.corner[i], reference_of(frame, i));
    gap.origin.push_back(low);
    gap.span.push_back(high - low);
    gap.volume *= std::max(0.0, (high - low) / (frame.nadir[i] - frame.ideal[i]));
  }
  return gap;
}

void Engine::evaluate(std::vector<Proposal> proposals) {
  if (proposals.size() > left()) proposals.resize(left());
  std::vector<std::vector<double>> points;
  for (const Proposal& proposal : proposals) {
    points.push_back(space_.point(proposal.candidate.unit, proposal.candidate.combination));
  }
  const std::vector<Record> records = run_.workers.evaluate(run_.archive, points, run_.options.stop);
  std::vector<double> gains;
  for (const Record& record : records) gains.push_back(samples_.add(record));
  made_ = run_.archive.size() - known_before_;
  credit(gains, proposals);
  if (run_.options.progress) {
    run_.options.progress({.evaluations = run_.archive.size(),
                           .max_evaluations = run_.options.max_evaluations,
                           .feasible = samples_.feasible_count(),
                           .front_size = samples_.front().size()});
  }
}

void Engine::credit(const std::vector<double>& gains, const std::vector<Proposal>& batch) {
  std::array<double, ways> sum{}, count{};
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const auto way = static_cast<std::size_t>(batch[i].way);
    sum[way] += gains[i];
    count[way] += 1;
    if (batch[i].way == Way::anchor && batch[i].which < anchor_failures_.size()) {
      int& failures = anchor_failures_[batch[i].which];
      failures = gains[i] > 1e-6 ? 0 : failures + 1;
    }
  }
  for (std::size_t way = 0; way < ways; ++way) {
    if (count[way] > 0) earned_[way] = 0.8 * earned_[way] + 0.2 * sum[way] / count[way];
  }
}

void Engine::initial_design() {
  const std::size_t n = space_.dimension();
  const std::uint64_t combinations = std::min<std::uint64_t>(space_.combinations(), 64);
  // A simplex and a bit for every combination of levels, a fifth of the budget at most.
  const std::size_t wanted =
      std::min<std::size_t>((2 * n + 4) * combinations, std::max<std::size_t>(run_.budget / 5, 1));
  while (samples_.size() < wanted && left() > 0 && !run_.options.stop.stop_requested() && !exhausted_) {
    std::vector<Proposal> batch;
    explore(batch, std::min({wanted - samples_.size(), left(), 4 * round_size()}));
    evaluate(std::move(batch));
  }
}

// Fills `batch` up to `size` with designs from no model, by what breeding and scattering earned lately.
void Engine::explore(std::vector<Proposal>& batch, std::size_t size) {
  std::set<std::vector<double>> taken;
  for (const Proposal& proposal : batch) {
    taken.insert(space_.point(proposal.candidate.unit, proposal.candidate.combination));
  }
  const std::vector<std::size_t> good = parents();
  int misses = 0;
  while (batch.size() < size && !exhausted_) {
    const double breed = earned_[static_cast<std::size_t>(Way::breed)];
    const double scatter = earned_[static_cast<std::size_t>(Way::scatter)];
    const double share = std::clamp(breed / std::max(breed + scatter, 1e-300), 0.3, 0.85);
    Way way = uniform(random_) < share && good.size() >= 3 ? Way::breed : Way::scatter;
    std::optional<Candidate> candidate;
    if (space_.dimension() > 0 && misses < 32) {
      candidate = way == Way::breed ? explorer_.breed(samples_, good) : explorer_.scatter(samples_);
    } else if (space_.design_count() > 0) {
      way = Way::scatter;
      candidate = explorer_.enumerate(samples_);
      if (!candidate) exhausted_ = true;
    }
    if (!candidate || !taken.insert(space_.point(candidate->unit, candidate->combination)).second) {
      ++misses;
      continue;
    }
    batch.push_back({.candidate = std::move(*candidate), .way = way, .which = 0});
  }
}

std::vector<std::size_t> Engine::parents() const {
  if (samples_.front().size() >= 8) return samples_.front();
  // Too few: the best by violation, then by the sum of normalised objectives.
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < samples_.size(); ++i) order.push_back(i);
  const auto rank = [&](std::size_t i) {
    const Sample& sample = samples_[i];
    double sum = 0;
    if (sample.feasible()) {
      for (std::size_t k = 0; k < sample.values.size(); ++k) {
        sum += (sample.values[k] - samples_.frame().ideal[k]) / (samples_.frame().nadir[k] - samples_.frame().ideal[k]);
      }
    }
    return std::tuple{!sample.evaluated, sample.violation, sum, i};
  };
  const std::size_t kept = std::min<std::size_t>(order.size(), 12);
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(kept), {}, rank);
  order.resize(kept);
  return order;
}

// Evaluated samples with the best scalar (violation priced in), none within 0.1 of a better one in every axis.
std::vector<std::size_t> Engine::best_apart(const Goal& goal, std::size_t count, std::uint64_t combination,
                                            bool any_combination) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    if (!sample.evaluated || (!any_combination && sample.combination != combination)) continue;
    const double price = goal.kind == Goal::Kind::feasibility || sample.violation == 0 ? 0 : 1 + 10 * sample.violation;
    order.emplace_back(goal.scalar(sample) + price, i);
  }
  std::ranges::sort(order);
  std::vector<std::size_t> kept;
  for (const auto& [scalar, i] : order) {
    if (kept.size() == count) break;
    const bool close = std::ranges::any_of(kept, [&](std::size_t k) {
      if (samples_[k].combination != samples_[i].combination) return false;
      return largest_difference(samples_[k].unit, samples_[i].unit) < 0.1;
    });
    if (!close) kept.push_back(i);
  }
  return kept;
}

// First between the gap's own neighbours; after a failure also elsewhere: other levels, other basins.
Region Engine::gap_region(const Goal& goal, const UpperBound& bound) {
  std::vector<std::size_t> definers;
  for (const std::size_t definer : bound.definers) {
    if (definer != UpperBound::none) definers.push_back(definer);
  }
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random_() % count); };
  if (bound.failures > 0 && uniform(random_) < 0.5) {
    const bool any = space_.combinations() == 1 || uniform(random_) < 0.5;
    const std::vector<std::size_t> others = best_apart(goal, 3, random_() % space_.combinations(), any);
    if (!others.empty()) {
      const std::size_t chosen = others[pick(others.size())];
      return {.from = chosen, .to = chosen, .margin = 1.0, .apart = apart(bound.failures), .seed = random_()};
    }
  }
  const std::size_t from = definers[pick(definers.size())];
  std::size_t to = definers[pick(definers.size())];
  for (const std::size_t other : definers) {
    if (other != from && samples_[other].combination == samples_[from].combination) to = other;
  }
  if (samples_[to].combination != samples_[from].combination) to = from;
  if (bound.failures == 0) return {.from = from, .to = to};
  return {.from = from, .to = to, .margin = 1.0, .apart = apart(bound.failures), .seed = random_()};
}

void Engine::add_gap_attempts(std::vector<Attempt>& list, std::size_t wanted) {
  if (samples_.objective_count() < 2) return;
  const std::vector<UpperBound>& bounds = samples_.bounds().all();
  std::vector<std::pair<double, std::size_t>> order;
  std::vector<Gap> gaps;
  for (std::size_t b = 0; b < bounds.size(); ++b) {
    gaps.push_back(gap_below(samples_, bounds[b]));
    const double priority = gaps[b].volume * std::pow(0.4, bounds[b].failures);
    if (priority > 0) order.emplace_back(-priority, b);
  }
  const std::size_t kept = std::min(order.size(), wanted);
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(kept));
  for (std::size_t i = 0; i < kept; ++i) {
    const std::size_t b = order[i].second;
    Attempt attempt{.goal = {.kind = Goal::Kind::gap, .origin = gaps[b].origin, .span = gaps[b].span, .to_beat = 0.999},
                    .way = Way::gap,
                    .which = b};
    attempt.region = gap_region(attempt.goal, bounds[b]);
    list.push_back(std::move(attempt));
  }
}

// The scale of a single objective: from the best to the median of all designs. (A front of one design has no range.)
double Engine::single_span() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (samples_[i].evaluated) values.push_back(samples_[i].values[0]);
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  const double least = std::max(1e-9, 1e-6 * std::abs(samples_.frame().ideal[0]));
  return std::max(std::abs(*middle - samples_.frame().ideal[0]), least);
}

void Engine::add_anchor_attempts(std::vector<Attempt>& list, std::size_t wanted) {
  const FrontFrame& frame = samples_.frame();
  const std::size_t objectives = samples_.objective_count();
  for (std::size_t slot = 0; slot < wanted; ++slot) {
    const std::size_t i = anchor_turn_++ % objectives;
    Goal goal{.kind = Goal::Kind::objective, .origin = frame.ideal, .span = Objectives(objectives)};
    for (std::size_t k = 0; k < objectives; ++k) {
      goal.span[k] = (frame.nadir[k] - frame.ideal[k]) * (k == i ? 1.0 : 1e3);
    }
    if (objectives == 1) goal.span = {single_span()};
    // Half of the attempts of one objective start from the best design, each with another reach; the others, and
    // those after failures, from further basins.
    const auto turn = static_cast<std::size_t>(anchor_failures_[i]) + slot / objectives;
    const std::size_t rank = objectives == 1 ? (slot < wanted / 2 ? 0 : slot - wanted / 2 + 1) : turn % 6;
    const std::vector<std::size_t> starts = best_apart(goal, rank + 1, 0, true);
    const std::size_t start = starts[std::min(rank, starts.size() - 1)];
    goal.to_beat = std::numeric_limits<double>::infinity();
    for (const std::size_t member : samples_.front())
      goal.to_beat = std::min(goal.to_beat, goal.scalar(samples_[member]));
    goal.to_beat -= 1e-7;
    Region region{.from = start, .to = start};
    if (turn > 0) {
      region.margin = 1.0;
      region.apart = apart(static_cast<int>(turn));
      region.seed = random_();
    }
    list.push_back({.goal = goal, .region = region, .way = Way::anchor, .which = i});
  }
}

void Engine::add_feasibility_attempts(std::vector<Attempt>& list, std::size_t wanted) {
  if (samples_.constraint_count() == 0) return;
  Goal goal{.kind = Goal::Kind::feasibility};
  const std::vector<std::size_t> starts = best_apart(goal, wanted, 0, true);
  for (const std::size_t start : starts) {
    goal.to_beat = goal.scalar(samples_[start]);
    list.push_back({.goal = goal,
                    .region = {.from = start, .to = start, .margin = 0.5},
                    .way = Way::anchor,
                    .which = samples_.objective_count()});
  }
}

std::vector<Attempt> Engine::attempts(std::size_t wanted) {
  std::vector<Attempt> list;
  if (samples_.feasible_count() == 0) {
    add_feasibility_attempts(list, wanted / 2);
    return list;
  }
  const std::size_t objectives = samples_.objective_count();
  if (objectives == 1) {
    add_anchor_attempts(list, wanted);
    return list;
  }
  const int fewest = *std::ranges::min_element(anchor_failures_);
  const std::size_t anchors = fewest < 4 ? objectives : (rounds_ % 4 == 0 ? 1 : 0);
  add_anchor_attempts(list, std::min(anchors, wanted));
  add_gap_attempts(list, wanted - std::min(anchors, wanted));
  return list;
}

void Engine::round() {
  const double model = std::max(earned_[0], earned_[1]);
  const double free = std::max(earned_[2], earned_[3]);
  const double share = std::clamp(model / std::max(model + free, 1e-300), 0.5, 0.9);
  const auto wanted = static_cast<std::size_t>(std::lround(share * static_cast<double>(round_size())));
  const std::vector<Attempt> list = attempts(std::min(wanted, left()));
  const std::size_t objectives = samples_.objective_count();
  if (run_.options.algorithm != Algorithm::automatic) return direct_round(list, run_.options.algorithm);
  if (objectives == 1 && rounds_ % rounds_between_descents == 0 && !space_.has_grid()) descend(list);
  std::vector<std::vector<Candidate>> found(list.size());
  run_.workers.run(list.size(), [&](std::size_t i) {
    if (!run_.options.stop.stop_requested()) found[i] = infill(samples_, list[i].goal, list[i].region);
  });
  std::vector<Proposal> batch;
  std::set<std::vector<double>> taken;
  if (samples_.objective_count() == 1 && !samples_.front().empty()) {
    // The answer must be the best of its grid neighbourhood.
    for (Candidate& candidate : unknown_neighbours(samples_, samples_.front().front())) {
      if (batch.size() >= round_size() / 2) break;
      taken.insert(space_.point(candidate.unit, candidate.combination));
      batch.push_back({.candidate = std::move(candidate), .way = Way::breed, .which = 0});
    }
  }
  for (std::size_t i = 0; i < list.size() && batch.size() < round_size(); ++i) {
    if (list[i].way == Way::gap) samples_.bounds().count_failure(list[i].which);  // a success replaces the bound
    bool placed = false;
    for (Candidate& candidate : found[i]) {
      if (!taken.insert(space_.point(candidate.unit, candidate.combination)).second) continue;
      batch.push_back({.candidate = std::move(candidate), .way = list[i].way, .which = list[i].which});
      placed = true;
      break;
    }
    if (!placed && list[i].way == Way::anchor && list[i].which < anchor_failures_.size()) {
      ++anchor_failures_[list[i].which];
    }
  }
  explore(batch, std::min(round_size(), left()));
  evaluate(std::move(batch));
  ++rounds_;
}

// Without a grid only: a difference over a grid step is no gradient. A model of a narrow curved valley is poor; NLopt
// on the problem itself then goes further, from the best design and from one other basin in turn. (A third of the
// evaluations; what it gains is in the decision record.)
void Engine::descend(const std::vector<Attempt>& list) {
  if (list.empty()) return;
  const std::size_t other = 1 + rounds_ / rounds_between_descents % list.size();
  std::vector<Attempt> two{list.front()};
  if (other < list.size()) two.push_back(list[list.size() - other]);
  direct_round(two, Algorithm::slsqp);
}

// The same goals, each pursued by an NLopt run on the problem itself.
void Engine::direct_round(const std::vector<Attempt>& list, Algorithm algorithm) {
  const std::size_t n = space_.dimension();
  const std::size_t share = std::max<std::size_t>(left() / std::max<std::size_t>(list.size(), 1), 1);
  const std::size_t budget = std::min<std::size_t>(share, 15 * (n + 1));
  std::vector<std::vector<Record>> found(list.size());
  const std::uint64_t seed = random_();
  const std::size_t tasks = std::min(list.size(), left());
  run_.workers.run(tasks, [&](std::size_t i) {
    const Attempt& attempt = list[i];
    const Sample& start = samples_[attempt.region.from];
    Box box{.lower = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n)),
            .upper = Eigen::VectorXd(static_cast<Eigen::Index>(n))};
    for (std::size_t axis = 0; axis < n; ++axis) box.upper[static_cast<Eigen::Index>(axis)] = space_.ceiling(axis);
    found[i] = run_direct(run_.archive, samples_,
                          {.algorithm = algorithm,
                           .goal = attempt.goal,
                           .start = {.unit = start.unit, .combination = start.combination},
                           .box = box,
                           .budget = budget,
                           .seed = seed + i},
                          run_.options.stop);
  });
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].way == Way::gap) samples_.bounds().count_failure(list[i].which);
    if (list[i].way == Way::anchor && list[i].which < anchor_failures_.size()) ++anchor_failures_[list[i].which];
  }
  for (const std::vector<Record>& records : found) {
    for (const Record& record : records) samples_.add(record);
  }
  made_ = run_.archive.size() - known_before_;
  if (left() > 0) {
    std::vector<Proposal> batch;
    explore(batch, std::min<std::size_t>(left(), 2));
    evaluate(std::move(batch));
  }
  ++rounds_;
}

StopReason Engine::run() {
  if (space_.design_count() > 0 && space_.design_count() <= run_.budget + samples_.size()) {
    // Fewer designs than evaluations allowed: all of them.
    while (left() > 0 && !run_.options.stop.stop_requested()) {
      std::vector<Proposal> batch;
      while (batch.size() < std::min<std::size_t>(left(), 1024)) {
        std::optional<Candidate> candidate = explorer_.enumerate(samples_);
        if (!candidate) break;
        batch.push_back({.candidate = std::move(*candidate), .way = Way::scatter, .which = 0});
      }
      if (batch.empty()) return StopReason::space_exhausted;
      evaluate(std::move(batch));
    }
  } else {
    initial_design();
    while (left() > 0 && !run_.options.stop.stop_requested() && !exhausted_) round();
  }
  if (run_.options.stop.stop_requested()) return StopReason::interrupted;
  const bool all = space_.design_count() > 0 && samples_.size() == space_.design_count();
  return all || exhausted_ ? StopReason::space_exhausted : StopReason::evaluation_limit;
}

}  // namespace

StopReason run_engine(const EngineRun& run) {
  return Engine{run}.run();
}

}  // namespace coilwright::sizing
