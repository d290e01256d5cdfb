#include "measurement/compare/hypothesis_search.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "measurement/compare/linear_screening.hpp"
#include "measurement/compare/rig_scale.hpp"
#include "measurement/compare/select_hypothesis.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Model;

// So many effects are followed to the end of their fit; the others are too far behind after a glance to matter.
constexpr std::size_t followed = 9;
// So many of the hypotheses of one level are starting points for the next.
constexpr std::size_t beam = 5;
// So many additions to each of them are fitted, of those that promise most.
constexpr std::size_t fitted_additions = 4;
// So many of a level are tried with their choices made otherwise.
constexpr std::size_t reconsidered = 4;
constexpr std::size_t most_effects = 3;
constexpr double worth_another = 0.5;

std::vector<Scored> collected(std::vector<std::optional<Scored>> found) {
  std::vector<Scored> out;
  for (std::optional<Scored>& one : found)
    if (one) out.push_back(std::move(*one));
  return out;
}

const Scored& best_of(const std::vector<Scored>& level, const Scored& otherwise) {
  const auto best = std::ranges::min_element(level, {}, [](const Scored& s) { return s.fit.chi_square; });
  return best == level.end() ? otherwise : *best;
}

std::string names(const Scored& s) {
  std::string out;
  for (const EffectKind* kind : s.kinds()) {
    if (!out.empty()) out += " + ";
    out += kind->id();
  }
  return out;
}

// The inputs of the first run by itself that the model cannot follow.
std::string inputs_that_fail(std::span<const replay::Record> records, const Trial& trial) {
  for (std::size_t r = 0; r < records.size(); ++r)
    if (!fit::evaluate_at(asking(records.subspan(r, 1), trial))) return "the inputs of " + records[r].run->name;
  return "these inputs";
}

Scored recalibrated(std::span<const replay::Record> records, const replay::DeclaredModel& declared) {
  Trial trial{.hypothesis = fit::Hypothesis(declared, {})};
  trial.start = trial.hypothesis.start();
  auto fitted = fitted_to_end(records, trial);
  if (!fitted)
    throw std::runtime_error("the declared model cannot be simulated under " + inputs_that_fail(records, trial));
  return std::move(*fitted);
}

// The same effects with one of their choices (a side, a warm start) made otherwise: what the first look took for better
// may not be so in company.
std::vector<Trial> with_other_choices(const Scored& s) {
  std::vector<Trial> out;
  const std::vector<Effect> effects = s.hypothesis.effects_at(s.fit.values);
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const auto numbers = effects[e].kind->parameters();
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      for (const double choice : numbers[n].choices) {
        if (choice == effects[e].values[n]) continue;
        std::vector<Effect> changed = effects;
        changed[e].values[n] = choice;
        out.push_back({.hypothesis = fit::Hypothesis(s.hypothesis.declared(), std::move(changed)),
                       .start = s.fit.values,
                       .starts_from = &s.fit});
      }
    }
  }
  return out;
}

// What is to be fitted on top of a hypothesis: one effect from the best of several starts, or all of them together.
struct Wish {
  const Scored* base{};
  std::vector<Effect> effects{};
  bool together{};

  [[nodiscard]] std::vector<const EffectKind*> kinds() const {
    std::vector<const EffectKind*> out = base->kinds();
    for (std::size_t i = 0; i < (together ? effects.size() : 1); ++i) out.push_back(effects[i].kind);
    std::ranges::sort(out);
    return out;
  }
};

// The same set of effects reached on two ways is fitted once, from where it was met first.
void drop_repeated(std::vector<Wish>& wanted) {
  std::vector<std::vector<const EffectKind*>> met;
  std::erase_if(wanted, [&](const Wish& one) {
    std::vector<const EffectKind*> kinds = one.kinds();
    if (std::ranges::find(met, kinds) != met.end()) return true;
    met.push_back(std::move(kinds));
    return false;
  });
}

class Search {
 public:
  explicit Search(const AttributionRequest& request) : request_(request), records_(request.records) {}

  Attribution run() {
    Attribution out;
    out.steps.push_back(recalibrated(records_, *request_.declared));
    const Model nominal = out.before().hypothesis.model_at(out.before().fit.values);
    scale_ = rig_scale(records_, nominal);
    find_kinds(nominal, out);
    say(fmt::format("recalibrated: rms residual {:.3g} times the noise", out.before().adequacy.level));

    const std::vector<Addition> offered = offered_to(out.before());
    std::vector<Scored> level = singles(out.before(), offered);
    std::vector<Scored> all;
    unit_ = unit_of_evidence(records_, best_of(level, out.before()));
    double excess = out.before().excess();
    const auto against = [&](const Scored& s) { return criterion(s, unit_); };
    for (std::size_t size = 1;; ++size) {
      std::ranges::stable_sort(level, {}, against);
      reconsider_choices(level);
      std::ranges::stable_sort(level, {}, against);
      if (!level.empty()) {
        const Scored& best = level.front();
        unit_ = std::min(unit_, unit_of_evidence(records_, best));
        say(fmt::format("best with {} effect{}: {}: rms residual {:.3g} times the noise, structure {:.2g}", size,
                        size == 1 ? "" : "s", names(best), best.adequacy.level, best.adequacy.structure));
      }
      const bool adequate = std::ranges::any_of(level, [](const Scored& s) { return s.adequacy.noise_only(); });
      all.insert(all.end(), level.begin(), level.end());
      if (adequate || out.before().adequacy.noise_only() || size == most_effects) break;
      // A third effect is worth its runs only where the second halved what was left.
      const double left = level.empty() ? excess : level.front().excess();
      if (size > 1 && left > worth_another * excess) break;
      excess = left;
      std::vector<Scored> next = larger(level, size == 1 ? &out.before() : nullptr, offered);
      if (next.empty()) break;
      level = std::move(next);
    }
    out.unit = unit_;
    choose(records_, std::move(all), out);
    return out;
  }

 private:
  void say(const std::string& line) const {
    if (request_.progress) request_.progress(line);
  }

  void find_kinds(const Model& nominal, Attribution& out) {
    for (const EffectKind* kind : request_.effects.kinds()) {
      const auto& declared = nominal.nominal_spec().effects;
      if (std::ranges::any_of(declared, [&](const Effect& effect) { return effect.kind == kind; })) {
        out.candidates.push_back({.effects = {kind}, .remark = "is in the declared model already"});
      } else if (const auto reason = kind->inapplicable(nominal.nominal_spec())) {
        out.candidates.push_back({.effects = {kind}, .remark = "does not fit this rig: " + *reason});
      } else {
        kinds_.push_back(kind);
      }
    }
  }

  [[nodiscard]] std::vector<Addition> offered_to(const Scored& base) const {
    return additions(records_, base, kinds_, scale_, request_.seed);
  }

  // Every effect alone: a glance at each, the best of them to their end.
  [[nodiscard]] std::vector<Scored> singles(const Scored& base, const std::vector<Addition>& offered) const {
    std::vector<std::optional<Glance>> glances(kinds_.size());
    std::mutex said;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, kinds_.size(), [&](std::size_t i) {
      glances[i] = glance_at(records_, base, worth_a_glance(kinds_[i], offered));
      const std::scoped_lock lock(said);
      if (++done % 8 == 0) say(fmt::format("{} of {} effects compared", done, kinds_.size()));
    });
    std::erase_if(glances, [](const std::optional<Glance>& one) { return !one; });
    std::ranges::stable_sort(glances, {}, [](const std::optional<Glance>& one) { return one->fitted.chi_square; });
    std::vector<std::optional<Scored>> found(glances.size());
    tbb::parallel_for(std::size_t{0}, glances.size(), [&](std::size_t i) {
      Glance& one = *glances[i];
      if (i < followed)
        found[i] = followed_to_end(records_, one);
      else
        found[i] = scored(records_, std::move(one.trial.hypothesis), std::move(one.fitted));
    });
    return collected(std::move(found));
  }

  // Replaces each of the best of a level (sorted) by itself with another choice where that is better.
  void reconsider_choices(std::vector<Scored>& level) const {
    const std::size_t count = std::min(reconsidered, level.size());
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      if (level[i].adequacy.noise_only()) return;
      const Scored as_found = level[i];
      for (const Trial& trial : with_other_choices(as_found)) {
        auto other = fitted_to_end(records_, trial);
        if (other && other->fit.chi_square < level[i].fit.chi_square) level[i] = std::move(*other);
      }
    });
  }

  // Hypotheses with one effect more than `level` (sorted, best first); with `base`, also pairs on top of it.
  [[nodiscard]] std::vector<Scored> larger(const std::vector<Scored>& level, const Scored* base,
                                           const std::vector<Addition>& offered) const {
    std::vector<Wish> wanted;
    for (std::size_t i = 0; i < std::min(beam, level.size()); ++i) {
      const std::vector<Addition> more = offered_to(level[i]);
      for (const EffectKind* kind : most_promising(more, fitted_additions))
        wanted.push_back({.base = &level[i], .effects = worth_a_glance(kind, more)});
    }
    if (base != nullptr) {
      for (auto& [first, second] : most_promising_pairs(*base, offered, fitted_additions))
        wanted.push_back({.base = base, .effects = {std::move(first), std::move(second)}, .together = true});
    }
    drop_repeated(wanted);
    std::vector<std::optional<Scored>> found(wanted.size());
    tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t i) {
      const Wish& wish = wanted[i];
      if (wish.together) {
        found[i] = fitted_to_end(records_, with(*wish.base, wish.effects));
      } else if (const auto one = glance_at(records_, *wish.base, wish.effects)) {
        found[i] = followed_to_end(records_, *one);
      }
    });
    return collected(std::move(found));
  }

  const AttributionRequest& request_;
  std::span<const replay::Record> records_;
  actuator::RigScale scale_;
  std::vector<const EffectKind*> kinds_;
  double unit_ = 1.0;
};

}  // namespace

Attribution attribute(const AttributionRequest& request) {
  return Search(request).run();
}

}  // namespace coilwright::measurement::compare
