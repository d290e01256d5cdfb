#include "coilwright/sizing/study/yield.hpp"

#include <algorithm>
#include <atomic>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

#include "sizing/problem/workers.hpp"
#include "sizing/study/builds.hpp"

namespace coilwright::sizing {
namespace {

using Shares = std::vector<std::vector<double>>;

constexpr double outside = 0.025;  // of a 95 % interval, each side

// A quantity of each build, with its limit where it has one.
struct Asked : AskedOfBuild {
  const Limit* limit{};
};

std::vector<Asked> asked_of(const Study& study) {
  std::vector<Asked> out;
  for (const StudyObjective& objective : study.objectives)
    out.push_back({{.quantity = of_one_build(objective), .high_is_worse = objective.sense == Sense::minimise}});
  for (const Limit& limit : study.limits) {
    // What holds for a mean or a deviation says nothing of one build.
    const std::optional<StatisticName> parts = statistic_named(limit.quantity.name);
    const bool of_each = !limit.of_build || !parts || parts->statistic.kind == Statistic::Kind::percentile;
    out.push_back({{.quantity = of_one_build(limit), .high_is_worse = limit.side == Limit::Side::at_most},
                   of_each ? &limit : nullptr});
  }
  // What no limit on another load or a temperature knows of.
  if (study.driver && std::ranges::none_of(out, [&](const Asked& each) {
        return each.quantity.name == study.driver->thermal_load.name;
      }))
    out.push_back({{.quantity = study.driver->thermal_load}});
  return out;
}

// Values of the builds, by quantity.
using Values = std::vector<std::vector<std::optional<double>>>;

std::vector<FailureCause> causes_of(std::span<const Build> builds) {
  constexpr std::size_t told = 4;
  std::vector<FailureCause> out;
  for (const Build& build : builds) {
    if (build.failure.empty()) continue;
    const auto known = std::ranges::find(out, build.failure, &FailureCause::reason);
    if (known == out.end())
      out.push_back({.reason = build.failure, .builds = 1});
    else
      ++known->builds;
  }
  std::ranges::stable_sort(out, std::greater(), &FailureCause::builds);
  if (out.size() <= told + 1) return out;
  FailureCause others{.reason = "other causes"};
  for (std::size_t i = told; i < out.size(); ++i) others.builds += out[i].builds;
  out.resize(told);
  out.push_back(std::move(others));
  return out;
}

Share share_of(std::size_t met, std::size_t all) {
  using Binomial = boost::math::binomial;
  const auto n = static_cast<double>(all);
  const auto k = static_cast<double>(met);
  return {.value = k / n,
          .low = met == 0 ? 0.0 : Binomial::find_lower_bound_on_p(n, k, outside),
          .high = met == all ? 1.0 : Binomial::find_upper_bound_on_p(n, k, outside)};
}

// Of the builds, by a limit on a percentile of them.
std::optional<double> asked_share(const Limit& limit) {
  const std::optional<StatisticName> parts = statistic_named(limit.quantity.name);
  if (!parts || parts->statistic.kind != Statistic::Kind::percentile) return std::nullopt;
  const double below = 0.01 * parts->statistic.percent;
  return limit.side == Limit::Side::at_most ? below : 1.0 - below;
}

// A design without something that is asked for counts as failed, whatever its limits.
bool keeps(const Asked& asked, const std::optional<double>& value) {
  return value && (asked.limit == nullptr || margin(*asked.limit, *value) >= 0.0);
}

std::size_t count_keeping_all(const std::vector<Asked>& asked, const Values& values) {
  std::size_t count = 0;
  for (std::size_t build = 0; build < values.front().size(); ++build) {
    bool all = true;
    for (std::size_t i = 0; i < asked.size(); ++i) all = all && keeps(asked[i], values[i][build]);
    count += all ? 1 : 0;
  }
  return count;
}

// Builds designs on all threads.
class Builder {
 public:
  Builder(const Study& study, const EvaluatedDesign& design, const YieldOptions& options, std::size_t of)
      : asked_(asked_of(study)),
        of_builds_(asked_.begin(), asked_.end()),
        uses_(worst_uses(*study.spread, design.view(), of_builds_)),
        design_{design},
        options_{options},
        of_{of},
        workers_(options.threads) {}

  [[nodiscard]] const std::vector<Asked>& asked() const noexcept { return asked_; }

  // Those that were begun before a stop.
  [[nodiscard]] std::vector<Build> builds(const Spread& spread, std::span<const std::vector<double>> shares) {
    std::vector<Build> out(shares.size());
    workers_.run(shares.size(), [&](std::size_t build) {
      if (options_.stop.stop_requested()) return;
      out[build] = build_of(spread, design_.view(), of_builds_, uses_, shares[build]);
      if (options_.progress) options_.progress(++done_, of_);
    });
    std::erase_if(out, [](const Build& build) { return build.values.empty(); });
    return out;
  }

 private:
  std::vector<Asked> asked_;
  std::vector<AskedOfBuild> of_builds_;  // the same
  std::vector<Use> uses_;
  const EvaluatedDesign& design_;
  const YieldOptions& options_;
  std::size_t of_;
  Workers workers_;
  std::atomic<std::size_t> done_ = 0;
};

Values values_of(std::span<const Build> builds) {
  Values out(builds.empty() ? 0 : builds.front().values.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    for (const Build& build : builds) out[i].push_back(build.values[i]);
  return out;
}

BuiltQuantity built_quantity(const Asked& asked, const std::vector<std::optional<double>>& values, const Spread& spread,
                             const EvaluatedDesign& design) {
  BuiltQuantity out{.name = asked.quantity.name,
                    .nominal = asked.quantity.value(design.view()),
                    .p05 = percentile(values, 5.0),
                    .p50 = percentile(values, 50.0),
                    .p95 = percentile(values, 95.0)};
  if (asked.in_every_use() && has_uses(spread)) out.of_uses = share_of_uses(spread);
  if (asked.limit == nullptr) return out;
  out.limit = name_of(Limit{.quantity = asked.quantity, .side = asked.limit->side, .value = asked.limit->value});
  const auto met = std::ranges::count_if(values, [&](const auto& value) { return keeps(asked, value); });
  out.keeps = share_of(static_cast<std::size_t>(met), values.size());
  out.asked = asked_share(*asked.limit);
  return out;
}

// Values at A, B and the mixed designs of one quantity; nothing where one is missing.
std::optional<SaltelliValues> complete(const std::vector<Values>& designs, std::size_t quantity) {
  const auto numbers = [&](const Values& values) -> std::optional<std::vector<double>> {
    std::vector<double> out;
    for (const std::optional<double>& value : values[quantity]) {
      if (!value) return std::nullopt;
      out.push_back(*value);
    }
    return out;
  };
  SaltelliValues out;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    std::optional<std::vector<double>> each = numbers(designs[i]);
    if (!each) return std::nullopt;
    if (i == 0)
      out.a = std::move(*each);
    else if (i == 1)
      out.b = std::move(*each);
    else
      out.mixed.push_back(std::move(*each));
  }
  return out;
}

// What is drawn independently of all else: scatters that move together, those of like parts, or one by itself.
struct Input {
  std::string name;
  std::vector<std::size_t> scatters;
};

std::vector<Input> inputs_of(const Spread& spread) {
  std::vector<Input> out;
  std::vector<bool> together(spread.scatters.size());
  for (const CorrelatedScatters& group : spread.correlated) {
    out.push_back({.name = group.name, .scatters = group.scatters});
    for (const std::size_t index : group.scatters) together[index] = true;
  }
  for (std::size_t i = 0; i < spread.scatters.size(); ++i) {
    if (together[i]) continue;
    const auto like = std::ranges::find(out, spread.scatters[i].name, &Input::name);
    if (like == out.end())
      out.push_back({.name = spread.scatters[i].name, .scatters = {i}});
    else
      like->scatters.push_back(i);
  }
  return out;
}

// A, B, and for each input A with its columns from B.
std::vector<Shares> saltelli_designs(const std::vector<Input>& inputs, std::size_t dimension, std::size_t count,
                                     std::uint64_t seed) {
  Shares a;
  Shares b;
  for (const std::vector<double>& both : sobol_shares(2 * dimension, count, seed)) {
    const auto middle = both.begin() + static_cast<std::ptrdiff_t>(dimension);
    a.emplace_back(both.begin(), middle);
    b.emplace_back(middle, both.end());
  }
  std::vector<Shares> out{a, b};
  for (const Input& input : inputs) {
    Shares mixed = a;
    for (std::size_t row = 0; row < count; ++row)
      for (const std::size_t column : input.scatters) mixed[row][column] = b[row][column];
    out.push_back(std::move(mixed));
  }
  return out;
}

// Half as far, or half as likely to be otherwise.
void halve(Scatter& scatter) {
  if (auto* normal = std::get_if<NormalDeviation>(&scatter.about)) {
    normal->sd *= 0.5;
  } else if (auto* uniform = std::get_if<UniformDeviation>(&scatter.about)) {
    const double middle = 0.5 * (uniform->low + uniform->high);
    *uniform = {.low = 0.5 * (uniform->low + middle), .high = 0.5 * (uniform->high + middle)};
  } else {
    auto& choices = std::get<OtherChoices>(scatter.about);
    choices.as_designed = 0.5 * (1.0 + choices.as_designed);
  }
}

Spread with_half(Spread spread, const Input& input) {
  for (const std::size_t index : input.scatters) halve(spread.scatters[index]);
  return spread;
}

// Builds that are made of one spread.
struct Block {
  Spread spread;
  std::shared_ptr<const Shares> shares;  // one by one
};

// The yield's own; then, with worths, Saltelli's first two designs, and of each input the builds with it halved and the
// design that mixes it in: what was made before a stop tells of whole inputs.
std::vector<Block> blocks_of(const Spread& spread, const std::vector<Input>& inputs, const YieldOptions& options) {
  const std::size_t dimension = spread.scatters.size();
  const auto shared = [](Shares shares) { return std::make_shared<const Shares>(std::move(shares)); };
  std::vector<Block> out{{.spread = spread, .shares = shared(random_shares(dimension, options.builds, options.seed))}};
  if (options.worth_builds == 0) return out;
  std::vector<Shares> designs = saltelli_designs(inputs, dimension, options.worth_builds, options.seed);
  const auto add = [&](Spread of, std::shared_ptr<const Shares> each) {
    out.push_back({.spread = std::move(of), .shares = std::move(each)});
  };
  add(spread, shared(std::move(designs[0])));
  add(spread, shared(std::move(designs[1])));
  const auto dice = shared(random_shares(dimension, options.worth_builds, options.seed + 1));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    add(with_half(spread, inputs[i]), dice);
    add(spread, shared(std::move(designs[2 + i])));
  }
  return out;
}

// From the values of all blocks but the first, or of the first of those, of the inputs whose builds are all there.
std::vector<ScatterWorth> worths_from(std::vector<Values> blocks, const std::vector<Asked>& asked,
                                      const std::vector<Input>& inputs, const YieldOptions& options) {
  if (blocks.size() < 2) return {};
  std::vector<ScatterWorth> out;
  std::vector<Values> designs{std::move(blocks[0]), std::move(blocks[1])};
  for (std::size_t halved = 2; halved + 1 < blocks.size(); halved += 2) {
    out.push_back({.scatter = inputs[out.size()].name,
                   .keeps_all = share_of(count_keeping_all(asked, blocks[halved]), options.worth_builds)});
    designs.push_back(std::move(blocks[halved + 1]));
  }
  for (std::size_t quantity = 0; quantity < asked.size(); ++quantity) {
    const std::optional<SaltelliValues> values = complete(designs, quantity);
    const std::optional<SobolIndices> indices =
        values ? sobol_indices(*values, options.seed) : std::optional<SobolIndices>();
    for (std::size_t input = 0; input < out.size(); ++input) {
      out[input].first.push_back(indices ? std::optional(indices->first[input]) : std::nullopt);
      out[input].total.push_back(indices ? std::optional(indices->total[input]) : std::nullopt);
    }
  }
  return out;
}

// From the first block.
Yield yield_without_worths(const std::vector<Asked>& asked, const Spread& spread, const EvaluatedDesign& design,
                           std::span<const Build> builds) {
  const Values values = values_of(builds);
  Yield out{.builds = builds.size(),
            .not_built = static_cast<std::size_t>(std::ranges::count(builds, false, &Build::has_performance)),
            .failures = causes_of(builds),
            .keeps_all = share_of(count_keeping_all(asked, values), builds.size())};
  for (std::size_t i = 0; i < asked.size(); ++i)
    out.quantities.push_back(built_quantity(asked[i], values[i], spread, design));
  return out;
}

const Spread& spread_of(const Study& study) {
  if (!study.spread) throw std::invalid_argument("a yield needs a study with a spread");
  return *study.spread;
}

}  // namespace

std::optional<Yield> yield_of(const Study& study, const EvaluatedDesign& design, const YieldOptions& options) {
  const std::vector<Input> inputs = inputs_of(spread_of(study));
  Builder builder(study, design, options, builds_of(study, options));
  std::vector<Build> builds;
  std::vector<Values> others;
  for (const Block& block : blocks_of(*study.spread, inputs, options)) {
    std::vector<Build> made = builder.builds(block.spread, *block.shares);
    if (options.stop.stop_requested() && !builds.empty()) break;
    if (builds.empty())
      builds = std::move(made);
    else
      others.push_back(values_of(made));
    if (options.stop.stop_requested()) break;
  }
  if (builds.empty()) return std::nullopt;
  Yield out = yield_without_worths(builder.asked(), *study.spread, design, builds);
  if (options.worth_builds == 0) return out;
  out.worths = worths_from(std::move(others), builder.asked(), inputs, options);
  out.worths_left = inputs.size() - out.worths.size();
  return out;
}

std::size_t builds_of(const Study& study, const YieldOptions& options) {
  return options.builds + options.worth_builds * (2 + 2 * inputs_of(spread_of(study)).size());
}

std::optional<std::vector<Build>> builds_in(const Study& study, const EvaluatedDesign& design,
                                            const YieldOptions& options, const IndexRange& range) {
  const std::vector<Block> blocks = blocks_of(spread_of(study), inputs_of(*study.spread), options);
  Builder builder(study, design, options, range.end - range.first);
  std::vector<Build> out;
  std::size_t begin = 0;
  for (const Block& block : blocks) {
    const std::span<const std::vector<double>> shares = *block.shares;
    const std::size_t first = std::clamp(range.first, begin, begin + shares.size()) - begin;
    const std::size_t end = std::clamp(range.end, begin, begin + shares.size()) - begin;
    std::ranges::move(builder.builds(block.spread, shares.subspan(first, end - first)), std::back_inserter(out));
    begin += shares.size();
  }
  return options.stop.stop_requested() ? std::nullopt : std::optional(std::move(out));
}

Yield yield_from(const Study& study, const EvaluatedDesign& design, const YieldOptions& options,
                 std::span<const Build> builds) {
  if (builds.size() != builds_of(study, options)) throw std::invalid_argument("builds: must be all of the yield");
  const std::vector<Asked> asked = asked_of(study);
  Yield out = yield_without_worths(asked, *study.spread, design, builds.first(options.builds));
  if (options.worth_builds == 0) return out;
  std::vector<Values> others;
  for (std::size_t begin = options.builds; begin < builds.size(); begin += options.worth_builds)
    others.push_back(values_of(builds.subspan(begin, options.worth_builds)));
  out.worths = worths_from(std::move(others), asked, inputs_of(*study.spread), options);
  return out;
}

}  // namespace coilwright::sizing
