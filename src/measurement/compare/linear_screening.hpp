#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "coilwright/actuator/effect.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {

/// An effect that could be added to a hypothesis, from one of its starts, and what a straight line from there promises.
struct Addition {
  actuator::Effect effect{};    ///< as strong as the line says
  Eigen::VectorXd direction{};  ///< where it takes the residuals (fit.hpp); empty where it cannot be simulated
  double gain{};                ///< fall of chi^2
};

/// Every start of every one of `kinds` that `base` does not have yet. Starts of effects with several numbers come a
/// second time scattered, drawn with `seed`. One run of all records each, in parallel.
[[nodiscard]] std::vector<Addition> additions(std::span<const replay::Record> records, const Scored& base,
                                              std::span<const actuator::EffectKind* const> kinds,
                                              const actuator::RigScale& scale, std::uint64_t seed);

/// The starts of one kind that are worth a glance: the one that promises most, the best of every other choice that
/// promises a tenth of it, and the next if it promises about as much.
[[nodiscard]] std::vector<actuator::Effect> worth_a_glance(const actuator::EffectKind* kind,
                                                           std::span<const Addition> offered);

/// The kinds that promise most, best first, at most so many.
[[nodiscard]] std::vector<const actuator::EffectKind*> most_promising(std::span<const Addition> offered,
                                                                      std::size_t most);

/// Pairs of which neither half need show by itself: those whose directions explain most together, of different kinds,
/// best first, at most so many.
[[nodiscard]] std::vector<std::pair<actuator::Effect, actuator::Effect>> most_promising_pairs(
    const Scored& base, std::span<const Addition> offered, std::size_t most);

}  // namespace coilwright::measurement::compare
