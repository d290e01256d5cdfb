#include "attribution/laboratory/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "attribution/laboratory/conditions.hpp"
#include "truth/hidden_effects.hpp"
#include "truth/random.hpp"

namespace attribution::laboratory {
namespace {

using truth::Random;
using truth::Standing;
using truth::laboratory::InputLog;
using truth::laboratory::Request;
using Names = std::vector<std::string>;

struct Amounts {
  std::uint64_t seed;
  int alone;   // sets with nothing hidden for each fault, camera and programme
  int paired;  // for each pair of faults
  int all;     // with all faults at once
  int clean;
  int far;
  int unknown_colour;
  int one;
  int two;
  int three;
  int outsiders;
  Standing outside;
};

constexpr Amounts amounts_of(PlanName name) {
  if (name == PlanName::kept)
    return {.seed = 0x5EA1ED,
            .alone = 0,
            .paired = 0,
            .all = 10,
            .clean = 2,
            .far = 2,
            .unknown_colour = 2,
            .one = 14,
            .two = 6,
            .three = 2,
            .outsiders = 10,
            .outside = Standing::kept};
  return {.seed = 20261121,
          .alone = 4,
          .paired = 2,
          .all = 22,
          .clean = 8,
          .far = 14,
          .unknown_colour = 12,
          .one = 96,
          .two = 36,
          .three = 14,
          .outsiders = 40,
          .outside = Standing::outsider};
}

template <typename Value>
void shuffle(std::vector<Value>& values, Random& random) {
  for (int i = static_cast<int>(values.size()) - 1; i > 0; --i) std::swap(values[i], values[random.below(i + 1)]);
}

Names names_of(std::span<const Condition> conditions) {
  Names out;
  for (const Condition& each : conditions) out.push_back(each.name);
  return out;
}

// Every pair of faults, and every single condition but far numbers.
std::vector<Names> all_pairs() {
  const Names single = names_of(faults());
  std::vector<Names> out;
  for (std::size_t i = 0; i < single.size(); ++i)
    for (std::size_t k = i + 1; k < single.size(); ++k) out.push_back({single[i], single[k]});
  return out;
}

std::vector<Names> all_alone() {
  std::vector<Names> out;
  for (const auto& list : {faults(), single_faults(), cameras_and_programmes()})
    for (const Condition& each : list)
      if (each.name != "far_numbers") out.push_back({each.name});
  return out;
}

// Sines do not touch faces and one run has no second clock: conditions under which effects are hidden.
std::vector<Names> for_effects() {
  std::vector<Names> out = all_alone();
  std::erase_if(out, [](const Names& names) { return names.front() == "one_run" || names.front() == "sines"; });
  const std::vector<Names> pairs = all_pairs();
  out.insert(out.end(), pairs.begin(), pairs.end());
  const Names all = names_of(faults());
  for (int i = 0; i < 12; ++i) out.push_back(all);
  for (int i = 0; i < 4; ++i) out.push_back({});
  return out;
}

Names kinds(Standing standing) {
  Names out;
  for (const truth::HiddenKind& kind : truth::hidden_kinds())
    if (kind.standing == standing && kind.id != "mains_hum") out.push_back(kind.name());  // a line is a colour of noise
  return out;
}

// Endless: each of `all` once per round, in an order that is drawn for every round.
template <typename Value>
class Turns {
 public:
  Turns(std::vector<Value> all, Random& random) : all_(std::move(all)), random_(random) {}
  const Value& next() {
    if (at_ == all_.size()) at_ = 0;
    if (at_ == 0) shuffle(all_, random_);
    return all_[at_++];
  }

 private:
  std::vector<Value> all_;
  Random& random_;
  std::size_t at_ = 0;
};

class Planner {
 public:
  explicit Planner(std::uint64_t seed) : random_(seed) {}

  void add(Category category, const Names& conditions, const Names& hidden = {}) {
    Case next{.number = 0, .category = category, .conditions = conditions, .request = {}};
    Request& request = next.request;
    // A driver that writes down what it does, and no fault of the clocks, unless a condition says otherwise.
    request.camera.frame_rate = 120.0;
    request.clocks.log = InputLog::every_change;
    if (conditions.empty()) {
      request.camera.frame_rate = 500.0;
      request.clocks.log = InputLog::beside_pictures;
      next.conditions = {"clean"};
    }
    for (const std::string& name : conditions) condition(name).impose(random_, request);
    request.seed = random_.seed();
    request.hidden = hidden;
    if (request.seed == 0) request.seed = 1;
    request.weakest = 8.0;
    request.strongest = 20.0;
    cases_.push_back(std::move(next));
  }

  // One in three at its bound.
  void add_one(const Names& conditions, const std::string& effect) {
    add(Category::one, conditions, {effect});
    if (ones_++ % 3 != 2) return;
    cases_.back().request.at_bound = true;
    cases_.back().request.strongest = 40.0;
  }

  void add_unknown_colour(int i) {
    static constexpr std::array colours{truth::laboratory::Colour::low_passed, truth::laboratory::Colour::pink};
    add(Category::colour_unknown, {"sines"});
    cases_.back().request.noise.colour = colours[i % 2];
    cases_.back().conditions = {"sines", "colour_unknown"};
  }

  std::vector<Case> finish(const Values& values) {
    shuffle(cases_, random_);
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      cases_[i].number = static_cast<int>(i);
      const auto value = values.find(cases_[i].number);
      if (cases_[i].category == Category::one && value != values.end()) cases_[i].request.values = {value->second};
    }
    return std::move(cases_);
  }

  Random& random() { return random_; }

 private:
  Random random_;
  std::vector<Case> cases_;
  int ones_ = 0;
};

// Different effects. coil_coil_force is too weak to be one of several.
Names several(Turns<std::string>& turns, int count) {
  Names out;
  while (static_cast<int>(out.size()) < count) {
    const std::string& next = turns.next();
    const std::string id = truth::hidden_kind(next).id;
    const bool there =
        std::any_of(out.begin(), out.end(), [&](const std::string& name) { return truth::hidden_kind(name).id == id; });
    if (!there && id != "coil_coil_force") out.push_back(next);
  }
  return out;
}

}  // namespace

std::string_view name_of(Category category) {
  switch (category) {
    case Category::nothing:
      return "nothing";
    case Category::far:
      return "far";
    case Category::colour_unknown:
      return "colour_unknown";
    case Category::one:
      return "one";
    case Category::two:
      return "two";
    case Category::three:
      return "three";
    case Category::outsider:
      return "outsider";
  }
  return "";
}

std::string joined(const std::vector<std::string>& conditions) {
  return fmt::format("{}", fmt::join(conditions, "+"));
}

std::vector<Case> plan(PlanName name, const Values& values, std::uint64_t seed) {
  const Amounts amounts = amounts_of(name);
  Planner planner(seed == 0 ? amounts.seed : seed);
  if (name == PlanName::each_effect) {
    for (const std::string& effect : kinds(Standing::catalogue))
      for (const Names& conditions : {Names{}, Names{"30_fps"}, Names{"numbers"}})
        planner.add(Category::one, conditions, {effect});
    return planner.finish(values);
  }
  for (const Names& one : all_alone())
    for (int i = 0; i < amounts.alone; ++i) planner.add(Category::nothing, one);
  for (const Names& pair : all_pairs())
    for (int i = 0; i < amounts.paired; ++i) planner.add(Category::nothing, pair);
  for (int i = 0; i < amounts.all; ++i) planner.add(Category::nothing, names_of(faults()));
  for (int i = 0; i < amounts.clean; ++i) planner.add(Category::nothing, {});
  for (int i = 0; i < amounts.far; ++i) planner.add(Category::far, {"far_numbers"});
  for (int i = 0; i < amounts.unknown_colour; ++i) planner.add_unknown_colour(i);

  Random& random = planner.random();
  Turns<Names> conditions(for_effects(), random);
  Turns<std::string> effects(kinds(Standing::catalogue), random);
  Turns<std::string> outsiders(kinds(amounts.outside), random);
  for (int i = 0; i < amounts.one; ++i) planner.add_one(conditions.next(), effects.next());
  for (int i = 0; i < amounts.two; ++i) planner.add(Category::two, conditions.next(), several(effects, 2));
  for (int i = 0; i < amounts.three; ++i) planner.add(Category::three, conditions.next(), several(effects, 3));
  for (int i = 0; i < amounts.outsiders; ++i) planner.add(Category::outsider, conditions.next(), {outsiders.next()});
  return planner.finish(values);
}

}  // namespace attribution::laboratory
