#pragma once

#include <exception>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "coilwright/simulation/quantity.hpp"

// What the quantities of systems are read from: a try of what is built from a design, which not every design stands.
namespace coilwright::systems {

/// What came of a try, or why there was none.
template <class Result>
using Try = std::variant<Result, simulation::NoValue>;

/// A design far from all hardware may break a rule of a room below; then it has no value, as far from one as
/// `infeasibility` says of the exception, and the search goes on. `work` returns a Try.
template <class Work, class Infeasibility>
[[nodiscard]] auto tried(const Work& work, const Infeasibility& infeasibility) -> std::invoke_result_t<const Work&> {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    return simulation::NoValue{.reason = failure.what(), .infeasibility = infeasibility(failure)};
  }
}

/// `value` of what came of a try and of its design; nothing where there was none.
template <class Result, class Value>
[[nodiscard]] auto of_try(const simulation::SharedResult<Try<Result>>& result, Value value) {
  return [result, value = std::move(value)](const simulation::DesignView& design) {
    const auto found = result.of(design);
    const auto* done = std::get_if<Result>(found.get());
    return done == nullptr ? std::nullopt : std::optional(value(*done, design));
  };
}

/// Why there was none; that a number of it is not finite where there was one.
template <class Result>
[[nodiscard]] auto why_none(const simulation::SharedResult<Try<Result>>& result) {
  return [result](const simulation::DesignView& design) -> simulation::NoValue {
    const auto found = result.of(design);
    const auto* none = std::get_if<simulation::NoValue>(found.get());
    return none == nullptr ? simulation::NoValue{.reason = "it is not finite"} : *none;
  };
}

}  // namespace coilwright::systems
