#include "sizing/search/surrogate_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>

#include "sizing/sampling/explorer.hpp"
#include "sizing/sampling/neighbours.hpp"
#include "sizing/sampling/random.hpp"
#include "sizing/search/nlopt_search.hpp"
#include "sizing/surrogate/infill.hpp"
#include "sizing/surrogate/planner.hpp"

namespace coilwright::sizing {
namespace {

// Designs per round. A power of two for the Sobol sequence; small enough to learn often, large enough for 16 threads.
constexpr std::size_t largest_round = 16;
// One objective means one place to improve: learning sooner is worth more than company.
constexpr std::size_t round_of_one_objective = 8;
constexpr std::size_t rounds_between_descents = 4;

struct Proposal {
  Candidate candidate;
  Way way{};
  std::size_t which{};
};

class Engine {
 public:
  explicit Engine(const EngineRun& run)
      : run_{run},
        samples_{run.samples},
        space_{samples_.space()},
        explorer_{space_, run.options.seed},
        random_{run.options.seed ^ 0x5DEECE66DULL},
        planner_{samples_, random_} {}

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
  [[nodiscard]] std::vector<std::size_t> parents() const;
  [[nodiscard]] std::vector<Candidate> surroundings_of_best(const std::vector<Attempt>& list) const;
  void explore(std::vector<Proposal>& batch, std::size_t size);
  void credit(const std::vector<double>& gains, const std::vector<Proposal>& batch);

  const EngineRun& run_;
  Samples& samples_;
  const DesignSpace& space_;
  Explorer explorer_;
  std::mt19937_64 random_;
  Planner planner_;
  std::size_t known_before_ = run_.archive.size();
  std::size_t made_ = 0;
  std::size_t rounds_ = 0;
  bool exhausted_ = false;
  std::array<double, ways> earned_{1, 1, 0, 1, 1};
  [[nodiscard]] double earned(Way way) const { return earned_[static_cast<std::size_t>(way)]; }
};

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
    if (batch[i].way == Way::anchor) planner_.count_anchor(batch[i].which, gains[i]);
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
    const double breed = earned(Way::breed), scatter = earned(Way::scatter);
    const double share = std::clamp(breed / std::max(breed + scatter, 1e-300), 0.3, 0.85);
    Way way = uniform(random_) < share && good.size() >= 3 ? Way::breed : Way::scatter;
    std::optional<Candidate> candidate;
    if (space_.dimension() > 0 && misses < 32) {
      candidate = way == Way::breed ? explorer_.breed(samples_, good) : explorer_.scatter(samples_);
    } else {
      // Breeding and scattering find only what is known: what is left of a grid is taken in its order.
      way = Way::scatter;
      candidate = space_.design_count() > 0 ? explorer_.enumerate(samples_) : std::nullopt;
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

// The answer must be the best of its grid neighbourhood: single steps first, then steps in two variables, of which
// limits that couple variables may leave nothing else; one per round, half of it near the end.
std::vector<Candidate> Engine::surroundings_of_best(const std::vector<Attempt>& list) const {
  const std::size_t best = samples_.front().front();
  const std::size_t half = round_size() / 2;
  std::vector<Candidate> near = unknown_neighbours(samples_, best);
  if (!near.empty()) {
    near.resize(std::min(near.size(), half));
    return near;
  }
  const auto anchor = std::ranges::find(list, Way::anchor, &Attempt::way);
  if (anchor == list.end()) return near;
  return near_misses(samples_, anchor->goal, best, left() < run_.budget / 6 ? half : half / 4);
}

void Engine::round() {
  const double model = std::max({earned(Way::gap), earned(Way::anchor), earned(Way::niche)});
  const double free = std::max(earned(Way::breed), earned(Way::scatter));
  const double share = std::clamp(model / std::max(model + free, 1e-300), 0.5, 0.9);
  const auto wanted = static_cast<std::size_t>(std::lround(share * static_cast<double>(round_size())));
  const std::vector<Attempt> list = planner_.plan(std::min(wanted, left()), rounds_);
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
    for (Candidate& candidate : surroundings_of_best(list)) {
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
    if (!placed && list[i].way == Way::anchor) planner_.count_anchor(list[i].which, 0.0);
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
    if (list[i].way == Way::anchor) planner_.count_anchor(list[i].which, 0.0);
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
