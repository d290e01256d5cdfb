#include "sizing/study/builds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "sizing/study/evaluate_design.hpp"

namespace coilwright::sizing {
namespace {

using simulation::DesignView;
using BuildValues = std::vector<std::optional<double>>;

// Without what it got and with .. for numbers, in which builds that fail alike differ.
std::string cause_in(const std::string& reason) {
  std::string out = reason.substr(0, reason.find(';'));
  std::size_t word = 0;
  do {
    const char first = out[out[word] == '-' ? word + 1 : word];
    if (first >= '0' && first <= '9')
      out.replace(word, std::min(out.find_first_of(" ,:", word), out.size()) - word, "..");
    word = out.find(' ', word) + 1;
  } while (word != 0);
  return out;
}

// What is asked of the build in the use of its shares alone.
Build in_one_use(const Spread& spread, const DesignView& design, std::span<const AskedOfBuild> asked,
                 std::span<const double> shares) {
  Build out{.values = BuildValues(asked.size())};
  const DesignResult result = built(spread, design, shares);
  if (const auto* none = std::get_if<NotEvaluated>(&result)) {
    out.has_performance = false;
    out.failure = cause_in(none->reason);
    return out;
  }
  const DesignView view = std::get<EvaluatedDesign>(result).view();
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::optional<double> value = asked[i].quantity.value(view);
    if (value && std::isfinite(*value))
      out.values[i] = value;
    else if (out.failure.empty())
      out.failure = cause_in(without_value(asked[i].quantity, view).reason);
  }
  return out;
}

std::vector<AskedOfBuild> in_every_use(std::span<const AskedOfBuild> asked) {
  std::vector<AskedOfBuild> out;
  std::ranges::copy_if(asked, std::back_inserter(out), &AskedOfBuild::in_every_use);
  return out;
}

// By how bad it is, the larger the worse: nothing is worse than all.
double badness(const AskedOfBuild& asked, const std::optional<double>& value) {
  if (!value) return std::numeric_limits<double>::infinity();
  return asked.high_is_worse ? *value : -*value;
}

// The ends of the law of a number of a use, as shares. Where laws have no ends, what lies below those of all such
// numbers is the stated share of the uses.
std::pair<double, double> ends_of(const Spread& spread, const Scatter& scatter) {
  if (!std::holds_alternative<NormalDeviation>(scatter.about)) return {0.0, 1.0};
  const auto endless = std::ranges::count_if(spread.scatters, [](const Scatter& each) {
    return each.of_use && std::holds_alternative<NormalDeviation>(each.about);
  });
  const double high = std::pow(spread.share_of_uses, 1.0 / static_cast<double>(endless));
  return {1.0 - high, high};
}

// Those that a quantity may be worst at, from what it is at the low end, in the middle and at the high end.
std::vector<double> worse_ends(std::pair<double, double> ends, double low, double middle, double high) {
  // What changes by less says nothing of how a build changes, whose curves are made to 1e-4.
  constexpr double alike = 1e-6;
  const double least = std::isfinite(middle) ? alike * std::abs(middle) : 0.0;
  if (low - middle > least && high - middle < -least) return {ends.first};
  if (high - middle > least && low - middle < -least) return {ends.second};
  return {ends.first, ends.second};
}

// Numbers of blocks are read by the quantities of blocks, and change nothing of the finger itself but a driven current.
bool may_depend_on(const AskedOfBuild& asked, const Scatter& scatter, const Spread& spread) {
  return !scatter.block_value || spread.driven.drive ||
         simulation::standard_quantities().find(asked.quantity.name) == nullptr;
}

// Added to one with which it agrees where both say something, or by itself.
void add(std::vector<Use>& uses, const Use& use) {
  const auto agrees = [&use](const Use& other) {
    for (std::size_t i = 0; i < use.size(); ++i)
      if (use[i] && other[i] && *use[i] != *other[i]) return false;
    return true;
  };
  const auto place = std::ranges::find_if(uses, agrees);
  if (place == uses.end()) return uses.push_back(use);
  for (std::size_t i = 0; i < use.size(); ++i)
    if (use[i]) (*place)[i] = use[i];
}

}  // namespace

std::vector<Use> worst_uses(const Spread& spread, const DesignView& design, std::span<const AskedOfBuild> all) {
  const std::vector<AskedOfBuild> asked = in_every_use(all);
  if (asked.empty() || !has_uses(spread)) return {};
  const std::size_t count = spread.scatters.size();
  std::vector<double> middle(count, 0.5);
  for (std::size_t i = 0; i < count; ++i)
    if (std::holds_alternative<OtherChoices>(spread.scatters[i].about)) middle[i] = 0.0;
  const BuildValues values = in_one_use(spread, design, asked, middle).values;
  std::vector<std::vector<Use>> found(asked.size(), {Use(count)});
  for (std::size_t axis = 0; axis < count; ++axis) {
    const Scatter& scatter = spread.scatters[axis];
    if (!scatter.of_use) continue;
    const std::pair<double, double> ends = ends_of(spread, scatter);
    const auto values_at = [&](double share) {
      std::vector<double> shares = middle;
      shares[axis] = share;
      return in_one_use(spread, design, asked, shares).values;
    };
    const BuildValues low = values_at(ends.first);
    const BuildValues high = values_at(ends.second);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (!may_depend_on(asked[i], scatter, spread)) continue;
      std::vector<Use> further;
      for (const double end :
           worse_ends(ends, badness(asked[i], low[i]), badness(asked[i], values[i]), badness(asked[i], high[i])))
        for (Use use : found[i]) {
          use[axis] = end;
          further.push_back(std::move(use));
        }
      found[i] = std::move(further);
    }
  }
  std::vector<Use> out;
  for (const std::vector<Use>& of_one : found)
    for (const Use& use : of_one)
      if (std::ranges::any_of(use, [](const auto& share) { return share.has_value(); })) add(out, use);
  return out;
}

Build build_of(const Spread& spread, const DesignView& design, std::span<const AskedOfBuild> asked,
               std::span<const Use> uses, std::span<const double> shares) {
  Build out = in_one_use(spread, design, asked, shares);
  const std::vector<AskedOfBuild> of_every_use = in_every_use(asked);
  for (const Use& use : uses) {
    std::vector<double> in_use(shares.begin(), shares.end());
    for (std::size_t i = 0; i < use.size(); ++i) in_use[i] = use[i].value_or(in_use[i]);
    const Build other = in_one_use(spread, design, of_every_use, in_use);
    if (out.failure.empty()) out.failure = other.failure;
    auto value = other.values.begin();
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (!asked[i].in_every_use()) continue;
      if (badness(asked[i], *value) > badness(asked[i], out.values[i])) out.values[i] = *value;
      ++value;
    }
  }
  return out;
}

}  // namespace coilwright::sizing
