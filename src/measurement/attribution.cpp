#include "attribution.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <random>
#include <stdexcept>
#include <utility>

#include "rig_scale.hpp"

namespace coilwright::measurement {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Model;

// A gain of the criterion by less than this decides nothing: odds of 20 to 1 (Kass and Raftery 1995, "strong").
constexpr double decisive = 6.0;
// What the first look spends on a fit before the best are followed to their end.
constexpr FitEffort glance{.iterations = 4, .tolerance = 1e-2};
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
// Share of a start's strength at which a fit begins anew that went wrong from the start itself.
constexpr double beside_absent = 0.05;

// A hypothesis to be fitted, and from where.
struct Trial {
  Hypothesis hypothesis;
  Eigen::VectorXd start{};
  const Fit* starts_from{};
};

// An effect that could be added, at one of its starts, and what it promises to explain.
struct Addition {
  Effect effect{};
  Eigen::VectorXd direction{};
  double gain{};
};

bool may_be_negative(const EffectKind& kind) {
  return std::ranges::any_of(kind.parameters(), [](const actuator::EffectParameter& number) {
    return number.absent && number.lower < *number.absent && number.upper > *number.absent;
  });
}

// A start with each of its numbers (but choices) made up to twice as large or small, inside the bounds. By mt19937_64,
// whose numbers are the same everywhere.
std::vector<double> scattered(const EffectKind& kind, std::vector<double> start, std::mt19937_64& random) {
  const auto numbers = kind.parameters();
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (!numbers[i].choices.empty() || !std::isfinite(start[i])) continue;
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    start[i] = std::clamp(start[i] * std::exp2(2.0 * share - 1.0), numbers[i].lower, numbers[i].upper);
  }
  return start;
}

class Search {
 public:
  explicit Search(const AttributionRequest& request) : request_(request), declared_(*request.declared) {}

  Attribution run() {
    Attribution out;
    out.steps.push_back(recalibrated());
    const Model nominal = out.before().hypothesis.model_at(out.before().fit.values);
    scale_ = rig_scale(request_.records, nominal);
    find_kinds(nominal, out);
    say(fmt::format("recalibrated: rms residual {:.3g} times the noise", out.before().adequacy.level));

    const std::vector<Addition> offered = additions(out.before());
    std::vector<Scored> level = singles(out.before(), offered);
    std::vector<Scored> all;
    unit_ = unit_of_evidence(request_.records, best_of(level, out.before()));
    double excess = excess_of(out.before());
    const auto better = [&](const Scored& a, const Scored& b) { return criterion(a) < criterion(b); };
    for (std::size_t size = 1;; ++size) {
      std::ranges::stable_sort(level, better);
      reconsider_choices(level);
      std::ranges::stable_sort(level, better);
      if (!level.empty()) {
        const Scored best = level.front();
        unit_ = std::min(unit_, unit_of_evidence(request_.records, best));
        say(fmt::format("best with {} effect{}: {}: rms residual {:.3g} times the noise, structure {:.2g}", size,
                        size == 1 ? "" : "s", names(best.hypothesis), best.adequacy.level, best.adequacy.structure));
      }
      const bool adequate = std::ranges::any_of(level, [](const Scored& s) { return s.adequacy.noise_only(); });
      all.insert(all.end(), level.begin(), level.end());
      if (adequate || out.before().adequacy.noise_only() || size == most_effects) break;
      // A third effect is worth its runs only where the second halved what was left.
      const double left = level.empty() ? excess : excess_of(level.front());
      if (size > 1 && left > worth_another * excess) break;
      excess = left;
      std::vector<Scored> next = larger(level, size == 1 ? &out.before() : nullptr, offered);
      if (next.empty()) break;
      level = std::move(next);
    }
    choose(all, out);
    return out;
  }

 private:
  [[nodiscard]] FitRequest asking(const Trial& trial) const {
    return {.hypothesis = &trial.hypothesis,
            .records = request_.records,
            .declared = &declared_,
            .start = trial.start,
            .starts_from = trial.starts_from};
  }

  void say(const std::string& line) const {
    if (request_.progress) request_.progress(line);
  }

  static std::string names(const Hypothesis& hypothesis) {
    std::string out;
    for (const Effect& effect : hypothesis.effects()) {
      if (!out.empty()) out += " + ";
      out += effect.kind->id();
    }
    return out;
  }

  [[nodiscard]] Scored scored(Hypothesis hypothesis, Fit fitted) const {
    const std::vector<ScaledResidual> residuals = scaled_residuals(request_.records, fitted);
    const Adequacy adequacy = adequacy_of(residuals, static_cast<int>(hypothesis.size()));
    return {.hypothesis = std::move(hypothesis), .fit = std::move(fitted), .adequacy = adequacy};
  }

  [[nodiscard]] Scored recalibrated() const {
    Trial trial{.hypothesis = Hypothesis(declared_, {})};
    trial.start = trial.hypothesis.start();
    auto fitted = fit(asking(trial));
    if (!fitted) throw std::runtime_error("the declared model cannot be simulated under these inputs");
    return scored(std::move(trial.hypothesis), std::move(*fitted));
  }

  void find_kinds(const Model& nominal, Attribution& out) {
    for (const EffectKind* kind : actuator::effect_catalogue()) {
      const auto& declared = nominal.spec().effects;
      if (std::ranges::any_of(declared, [&](const Effect& effect) { return effect.kind == kind; })) {
        out.candidates.push_back({.effects = {kind}, .remark = "is in the declared model already"});
      } else if (const auto reason = kind->inapplicable(nominal.spec())) {
        out.candidates.push_back({.effects = {kind}, .remark = "does not fit this rig: " + *reason});
      } else {
        kinds_.push_back(kind);
      }
    }
  }

  // `base` with one effect more, from one of its starts.
  [[nodiscard]] Trial with(const Scored& base, const Effect& effect) const {
    std::vector<Effect> effects = base.hypothesis.effects_at(base.fit.values);
    effects.push_back(effect);
    Trial trial{.hypothesis = Hypothesis(declared_, std::move(effects)), .starts_from = &base.fit};
    trial.start = trial.hypothesis.start();
    trial.start.head(base.fit.values.size()) = base.fit.values;
    return trial;
  }

  [[nodiscard]] std::optional<Scored> fitted_to_end(Trial trial) const {
    auto fitted = fit(asking(trial));
    if (!fitted) return std::nullopt;
    return scored(std::move(trial.hypothesis), std::move(*fitted));
  }

  static std::vector<double> choices_of(const Effect& effect) {
    std::vector<double> out;
    const auto numbers = effect.kind->parameters();
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (!numbers[i].choices.empty()) out.push_back(effect.values[i]);
    return out;
  }

  // The starts of one kind that are worth a glance: the one that promises most, the best of every other choice that
  // promises a tenth of it, and the next if it promises about as much.
  static std::vector<Effect> worth_a_glance(const EffectKind* kind, const std::vector<Addition>& offered) {
    std::vector<const Addition*> of_kind;
    for (const Addition& addition : offered)
      if (addition.effect.kind == kind) of_kind.push_back(&addition);
    std::ranges::stable_sort(of_kind, [](const Addition* a, const Addition* b) { return a->gain > b->gain; });
    std::vector<Effect> out;
    std::vector<std::vector<double>> met;
    for (std::size_t i = 0; i < of_kind.size(); ++i) {
      const Addition& addition = *of_kind[i];
      std::vector<double> choices = choices_of(addition.effect);
      const bool fresh = std::ranges::find(met, choices) == met.end();
      if (i > 0 && addition.gain <= (fresh ? 0.1 : 0.7) * of_kind[0]->gain) continue;
      if (i > 1 && !fresh) continue;
      out.push_back(addition.effect);
      met.push_back(std::move(choices));
    }
    return out;
  }

  // A few iterations from each start; the best of them, and the hypothesis it belongs to.
  struct Glance {
    Trial trial;
    Fit fitted{};
  };
  [[nodiscard]] std::optional<Glance> glance_at(const Scored& base, const std::vector<Effect>& starts) const {
    std::optional<Glance> best;
    const auto look = [&](const Effect& start) {
      Trial trial = with(base, start);
      FitRequest request = asking(trial);
      request.effort = glance;
      auto fitted = fit(request);
      if (!fitted || (best && fitted->chi_square >= best->fitted.chi_square)) return;
      best.emplace(Glance{.trial = std::move(trial), .fitted = std::move(*fitted)});
    };
    for (const Effect& start : starts) look(start);
    // A start so strong that the fit lost its way: again from beside the model without the effect.
    if (!best || best->fitted.chi_square >= base.fit.chi_square) {
      for (Effect start : starts) {
        weaken(start, beside_absent);
        look(start);
      }
    }
    return best;
  }

  // Every effect alone: a glance at each, the best of them to their end.
  [[nodiscard]] std::vector<Scored> singles(const Scored& base, const std::vector<Addition>& offered) const {
    std::vector<std::optional<Glance>> glances(kinds_.size());
    std::mutex said;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, kinds_.size(), [&](std::size_t i) {
      glances[i] = glance_at(base, worth_a_glance(kinds_[i], offered));
      const std::scoped_lock lock(said);
      if (++done % 8 == 0) say(fmt::format("{} of {} effects compared", done, kinds_.size()));
    });
    std::erase_if(glances, [](const std::optional<Glance>& one) { return !one; });
    std::ranges::stable_sort(glances, {}, [](const std::optional<Glance>& one) { return one->fitted.chi_square; });
    std::vector<std::optional<Scored>> found(glances.size());
    tbb::parallel_for(std::size_t{0}, glances.size(), [&](std::size_t i) {
      Glance& one = *glances[i];
      if (i >= followed) {
        found[i] = scored(one.trial.hypothesis, std::move(one.fitted));
        return;
      }
      one.trial.start = one.fitted.values;
      one.trial.starts_from = &one.fitted;
      found[i] = fitted_to_end(one.trial);
    });
    return collected(std::move(found));
  }

  // The same effects with one of their choices (a side, a warm start) made otherwise: what the first look took for
  // better may not be so in company.
  [[nodiscard]] std::vector<Trial> with_other_choices(const Scored& s) const {
    std::vector<Trial> out;
    const std::vector<Effect> effects = s.hypothesis.effects_at(s.fit.values);
    for (std::size_t e = 0; e < effects.size(); ++e) {
      const auto numbers = effects[e].kind->parameters();
      for (std::size_t n = 0; n < numbers.size(); ++n) {
        for (const double choice : numbers[n].choices) {
          if (choice == effects[e].values[n]) continue;
          std::vector<Effect> changed = effects;
          changed[e].values[n] = choice;
          out.push_back(
              {.hypothesis = Hypothesis(declared_, std::move(changed)), .start = s.fit.values, .starts_from = &s.fit});
        }
      }
    }
    return out;
  }

  // Replaces each of the best of a level (sorted) by itself with another choice where that is better.
  void reconsider_choices(std::vector<Scored>& level) const {
    const std::size_t count = std::min(reconsidered, level.size());
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      if (level[i].adequacy.noise_only()) return;
      const Scored as_found = level[i];
      for (Trial& trial : with_other_choices(as_found)) {
        auto other = fitted_to_end(std::move(trial));
        if (other && other->fit.chi_square < level[i].fit.chi_square) level[i] = std::move(*other);
      }
    });
  }

  static std::vector<Scored> collected(std::vector<std::optional<Scored>> found) {
    std::vector<Scored> out;
    for (std::optional<Scored>& one : found)
      if (one) out.push_back(std::move(*one));
    return out;
  }

  static const Scored& best_of(const std::vector<Scored>& level, const Scored& otherwise) {
    const auto best = std::ranges::min_element(level, {}, [](const Scored& s) { return s.fit.chi_square; });
    return best == level.end() ? otherwise : *best;
  }

  // What speaks against a hypothesis: misfit, and a charge for every number of its effects (Schwarz 1978, with the
  // number of independent samples).
  [[nodiscard]] double criterion(const Scored& s) const {
    const auto samples = static_cast<double>(s.fit.samples());
    const double charge = std::log(std::max(std::exp(1.0), samples / unit_));
    const double numbers = static_cast<double>(s.hypothesis.size()) - static_cast<double>(declared_.calibration.size());
    return s.fit.chi_square / unit_ + numbers * charge;
  }

  // Makes a start as strong as the linear look says: `share` of what it was, its sign included.
  static void scale_start(Effect& effect, double share) {
    constexpr double weakest = 0.3;  // weaker ones leave a shape without a slope
    constexpr double strongest = 3.0;
    weaken(effect, std::copysign(std::clamp(std::abs(share), weakest, strongest), share));
  }

  // Takes an effect to `share` of its distance from absent.
  static void weaken(Effect& effect, double share) {
    const auto numbers = effect.kind->parameters();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!numbers[i].choices.empty() || !numbers[i].absent || std::isinf(*numbers[i].absent)) continue;
      const double absent = *numbers[i].absent;
      effect.values[i] = std::clamp(absent + share * (effect.values[i] - absent), numbers[i].lower, numbers[i].upper);
    }
  }

  // Squared residual above the noise.
  static double excess_of(const Scored& s) { return s.fit.chi_square - static_cast<double>(s.fit.samples()); }

  // Every start of every effect that `base` does not have, with where it would take the residuals.
  [[nodiscard]] std::vector<Addition> additions(const Scored& base) const {
    std::vector<Addition> out;
    std::mt19937_64 random(request_.seed);
    for (const EffectKind* kind : kinds_) {
      const auto& there = base.hypothesis.effects();
      if (std::ranges::any_of(there, [&](const Effect& effect) { return effect.kind == kind; })) continue;
      for (std::vector<double>& start : kind->starts(scale_)) {
        // Where a fit is not convex the effect has more than one number (a shape besides a size).
        if (start.size() > 1) out.push_back({.effect = {.kind = kind, .values = scattered(*kind, start, random)}});
        out.push_back({.effect = {.kind = kind, .values = std::move(start)}});
      }
    }
    tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
      const Trial trial = with(base, out[i].effect);
      auto moved = direction(asking(trial), base.fit);
      if (!moved) return;
      const double along = -moved->dot(base.fit.stacked);
      const double square = moved->squaredNorm();
      if (square <= 0.0 || (along < 0.0 && !may_be_negative(*out[i].effect.kind))) return;
      out[i].gain = along * along / square;
      scale_start(out[i].effect, along / square);
      out[i].direction = std::move(*moved);
    });
    return out;
  }

  // What is to be fitted on top of a hypothesis: one effect from the best of several starts, or two together.
  struct Wish {
    const Scored* base{};
    std::vector<Effect> effects{};
    bool together{};
  };
  using Wanted = std::vector<Wish>;

  // The additions that promise most, each kind once.
  static void want_best(const Scored& base, std::vector<Addition> offered, Wanted& wanted) {
    std::ranges::stable_sort(offered, [](const Addition& a, const Addition& b) { return a.gain > b.gain; });
    std::vector<const EffectKind*> taken;
    for (const Addition& addition : offered) {
      if (taken.size() == fitted_additions || addition.gain <= 0.0) break;
      if (std::ranges::find(taken, addition.effect.kind) != taken.end()) continue;
      taken.push_back(addition.effect.kind);
      wanted.push_back({.base = &base, .effects = worth_a_glance(addition.effect.kind, offered)});
    }
  }

  // Pairs of which neither half need show by itself: the best of all that two directions explain together.
  static void want_pairs(const Scored& base, const std::vector<Addition>& offered, Wanted& wanted) {
    struct Pair {
      std::size_t first{}, second{};
      double gain{};
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < offered.size(); ++i) {
      for (std::size_t j = i + 1; j < offered.size(); ++j) {
        const Addition& a = offered[i];
        const Addition& b = offered[j];
        if (a.effect.kind == b.effect.kind || a.direction.size() == 0 || b.direction.size() == 0) continue;
        const double aa = a.direction.squaredNorm();
        const double bb = b.direction.squaredNorm();
        const double ab = a.direction.dot(b.direction);
        const double determinant = aa * bb - ab * ab;
        if (determinant <= 1e-6 * aa * bb) continue;
        const double ra = -a.direction.dot(base.fit.stacked);
        const double rb = -b.direction.dot(base.fit.stacked);
        const double share_a = (bb * ra - ab * rb) / determinant;
        const double share_b = (aa * rb - ab * ra) / determinant;
        if ((share_a < 0.0 && !may_be_negative(*a.effect.kind)) || (share_b < 0.0 && !may_be_negative(*b.effect.kind)))
          continue;
        pairs.push_back({.first = i, .second = j, .gain = share_a * ra + share_b * rb});
      }
    }
    std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) { return a.gain > b.gain; });
    std::vector<std::pair<const EffectKind*, const EffectKind*>> taken;
    for (const Pair& pair : pairs) {
      if (taken.size() == fitted_additions) break;
      const std::pair kinds{offered[pair.first].effect.kind, offered[pair.second].effect.kind};
      if (std::ranges::find(taken, kinds) != taken.end()) continue;
      taken.push_back(kinds);
      wanted.push_back(
          {.base = &base, .effects = {offered[pair.first].effect, offered[pair.second].effect}, .together = true});
    }
  }

  // Hypotheses with one effect more than `level` (sorted, best first); with `base`, also pairs on top of it.
  [[nodiscard]] std::vector<Scored> larger(const std::vector<Scored>& level, const Scored* base,
                                           const std::vector<Addition>& offered) const {
    Wanted wanted;
    for (std::size_t i = 0; i < std::min(beam, level.size()); ++i) want_best(level[i], additions(level[i]), wanted);
    if (base != nullptr) want_pairs(*base, offered, wanted);
    drop_repeated(wanted);
    std::vector<std::optional<Scored>> found(wanted.size());
    tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t i) {
      const Wish& wish = wanted[i];
      found[i] = wish.together ? both(*wish.base, wish.effects) : best_from(*wish.base, wish.effects);
    });
    return collected(std::move(found));
  }

  [[nodiscard]] std::optional<Scored> both(const Scored& base, const std::vector<Effect>& added) const {
    std::vector<Effect> effects = base.hypothesis.effects_at(base.fit.values);
    effects.insert(effects.end(), added.begin(), added.end());
    Trial trial{.hypothesis = Hypothesis(declared_, std::move(effects)), .starts_from = &base.fit};
    trial.start = trial.hypothesis.start();
    trial.start.head(base.fit.values.size()) = base.fit.values;
    return fitted_to_end(std::move(trial));
  }

  [[nodiscard]] std::optional<Scored> best_from(const Scored& base, const std::vector<Effect>& starts) const {
    std::optional<Glance> one = glance_at(base, starts);
    if (!one) return std::nullopt;
    one->trial.start = one->fitted.values;
    one->trial.starts_from = &one->fitted;
    return fitted_to_end(one->trial);
  }

  // The same set of effects reached on two ways is fitted once, from where it was met first.
  static void drop_repeated(Wanted& wanted) {
    std::vector<std::vector<const EffectKind*>> met;
    std::erase_if(wanted, [&](const auto& one) {
      std::vector<const EffectKind*> kinds;
      for (const Effect& effect : one.base->hypothesis.effects()) kinds.push_back(effect.kind);
      for (const Effect& effect : one.effects)
        if (one.together || kinds.empty() || kinds.back() != effect.kind) kinds.push_back(effect.kind);
      std::ranges::sort(kinds);
      if (std::ranges::find(met, kinds) != met.end()) return true;
      met.push_back(std::move(kinds));
      return false;
    });
  }

  // An effect that ended where it is not there explains nothing.
  static bool absent(const Scored& s) {
    const std::vector<Effect> effects = s.hypothesis.effects_at(s.fit.values);
    return std::ranges::any_of(effects, [](const Effect& effect) {
      const auto numbers = effect.kind->parameters();
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        // A limit that is absent at infinity is never there; one beyond the motion gains nothing.
        if (!numbers[i].absent || std::isinf(*numbers[i].absent)) continue;
        const double away = std::abs(effect.values[i] - *numbers[i].absent);
        if (away <= 1e-9 * std::max(1e-12, std::abs(*numbers[i].absent))) return true;
      }
      return false;
    });
  }

  void choose(std::vector<Scored>& all, Attribution& out) {
    out.unit = unit_;
    const double before = criterion(out.before());
    std::erase_if(all, [&](const Scored& s) {
      if (!absent(s)) return false;
      out.candidates.push_back({.effects = kinds_of(s), .remark = "fits best where it is absent"});
      return true;
    });
    // What is no better than the same model without it was not improved by any of its starts.
    std::erase_if(all, [&](const Scored& s) {
      if (s.fit.chi_square <= out.before().fit.chi_square * (1.0 + 1e-9)) return false;
      out.candidates.push_back({.effects = kinds_of(s), .remark = "fits no better than without it"});
      return true;
    });
    std::ranges::stable_sort(all, [&](const Scored& a, const Scored& b) { return criterion(a) < criterion(b); });
    std::vector<Candidate> ranked;
    for (const Scored& s : all) ranked.push_back(candidate(s, out.before(), before));
    out.candidates.insert(out.candidates.begin(), ranked.begin(), ranked.end());
    if (all.empty() || before - criterion(all.front()) < decisive) return;

    // Of all that come within a decisive gain of the best: the simplest.
    const double limit = criterion(all.front()) + decisive;
    std::vector<Scored> rivals;
    for (Scored& s : all)
      if (criterion(s) <= limit) rivals.push_back(std::move(s));
    const auto simplest = std::ranges::min_element(
        rivals, {}, [](const Scored& s) { return std::pair(s.hypothesis.effects().size(), s.hypothesis.size()); });
    Scored chosen = std::move(*simplest);
    rivals.erase(simplest);
    // A rival that is more than the choice and something on top is not another explanation.
    std::erase_if(rivals, [&](const Scored& s) { return contains(kinds_of(s), kinds_of(chosen)); });
    add_steps(std::move(chosen), out);
    out.rivals = std::move(rivals);
    out.indistinguishable = sets_of(out);
  }

  static std::vector<const EffectKind*> kinds_of(const Scored& s) {
    std::vector<const EffectKind*> out;
    for (const Effect& effect : s.hypothesis.effects()) out.push_back(effect.kind);
    return out;
  }

  static bool contains(const std::vector<const EffectKind*>& all, const std::vector<const EffectKind*>& some) {
    return std::ranges::all_of(some, [&](const EffectKind* kind) { return std::ranges::find(all, kind) != all.end(); });
  }

  [[nodiscard]] Candidate candidate(const Scored& s, const Scored& base, double before) const {
    return {.effects = kinds_of(s),
            .evidence = {.chi_square_before = base.fit.chi_square,
                         .chi_square_after = s.fit.chi_square,
                         .criterion_gain = before - criterion(s),
                         .cross_validated_gain = std::numeric_limits<double>::quiet_NaN(),
                         .correlation_time = correlation_time(scaled_residuals(request_.records, s.fit))}};
  }

  // The choice, and the way to it: at each step the effect that by itself explains most of what is left.
  void add_steps(Scored chosen, Attribution& out) const {
    std::vector<Effect> left = chosen.hypothesis.effects_at(chosen.fit.values);
    std::vector<Effect> taken;
    while (left.size() > 1) {
      std::optional<Scored> best;
      std::size_t which = 0;
      for (std::size_t i = 0; i < left.size(); ++i) {
        const Scored& base = out.after();
        auto one = fitted_to_end(with(base, left[i]));
        if (one && (!best || one->fit.chi_square < best->fit.chi_square)) {
          best = std::move(one);
          which = i;
        }
      }
      if (!best) break;
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(which));
      out.steps.push_back(std::move(*best));
    }
    // The last step is the choice itself, its effects in the order of the steps.
    if (left.size() == 1 && out.steps.size() > 1) {
      if (auto last = fitted_to_end(with(out.after(), left.front()));
          last && last->fit.chi_square <= chosen.fit.chi_square * (1 + 1e-6)) {
        out.steps.push_back(std::move(*last));
        return;
      }
    }
    out.steps.push_back(std::move(chosen));
  }

  // For each effect of the choice the others that could stand in its place.
  static std::vector<std::vector<const EffectKind*>> sets_of(const Attribution& out) {
    std::vector<std::vector<const EffectKind*>> sets;
    const std::vector<const EffectKind*> chosen = kinds_of(out.after());
    for (const EffectKind* kind : chosen) {
      std::vector<const EffectKind*> set{kind};
      for (const Scored& rival : out.rivals) {
        const std::vector<const EffectKind*> kinds = kinds_of(rival);
        if (std::ranges::find(kinds, kind) != kinds.end()) continue;
        for (const EffectKind* other : kinds)
          if (std::ranges::find(chosen, other) == chosen.end() && std::ranges::find(set, other) == set.end())
            set.push_back(other);
      }
      if (set.size() > 1) sets.push_back(std::move(set));
    }
    return sets;
  }

  const AttributionRequest& request_;
  const DeclaredModel& declared_;
  actuator::RigScale scale_;
  std::vector<const EffectKind*> kinds_;
  double unit_ = 1.0;
};

// Chi^2 of a run at values that it had no part in.
double held_out_chi_square(std::span<const Record> records, const DeclaredModel& declared, const Scored& s,
                           std::size_t run) {
  const Eigen::MatrixXd others = s.fit.normal - s.fit.runs[run].normal;
  Eigen::VectorXd scales(s.hypothesis.size());
  for (Eigen::Index i = 0; i < scales.size(); ++i)
    scales[i] = s.hypothesis.parameters()[static_cast<std::size_t>(i)].scale;
  const Eigen::MatrixXd scaled = scales.asDiagonal() * others * scales.asDiagonal();
  // Residuals r with slope dr/dx: the others' optimum lies at +N^-1 g of the run left out, for at the common optimum
  // all slopes add up to nothing.
  Eigen::VectorXd step = scaled.completeOrthogonalDecomposition().solve(scales.asDiagonal() * s.fit.runs[run].slope);
  step = scales.asDiagonal() * step.cwiseMax(-1.0).cwiseMin(1.0);
  Eigen::VectorXd values = s.fit.values + step;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const FitParameter& parameter = s.hypothesis.parameters()[static_cast<std::size_t>(i)];
    values[i] = std::clamp(values[i], parameter.lower, parameter.upper);
  }
  const auto there = evaluate_at(
      {.hypothesis = &s.hypothesis, .records = records.subspan(run, 1), .declared = &declared, .start = values});
  return there ? there->chi_square : std::numeric_limits<double>::infinity();
}

}  // namespace

double unit_of_evidence(std::span<const Record> records, const Scored& reference) {
  if (reference.adequacy.noise_only()) return 1.0;
  const double mean_square = reference.fit.chi_square / static_cast<double>(reference.fit.samples());
  return std::max(1.0, mean_square * correlation_time(scaled_residuals(records, reference.fit)));
}

double cross_validated_gain(std::span<const Record> records, const DeclaredModel& declared, const Scored& a,
                            const Scored& b) {
  if (records.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> with(records.size());
  std::vector<double> without(records.size());
  tbb::parallel_for(std::size_t{0}, records.size(), [&](std::size_t r) {
    without[r] = held_out_chi_square(records, declared, a, r);
    with[r] = held_out_chi_square(records, declared, b, r);
  });
  double excess_with = 0.0;
  double excess_without = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const auto noise = static_cast<double>(a.fit.runs[r].residuals.size());
    excess_with += with[r] - noise;
    excess_without += without[r] - noise;
  }
  return 1.0 - excess_with / excess_without;
}

Attribution attribute(const AttributionRequest& request) {
  return Search(request).run();
}

}  // namespace coilwright::measurement
