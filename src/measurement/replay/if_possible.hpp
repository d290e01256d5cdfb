#pragma once

#include <functional>
#include <optional>
#include <string>

namespace coilwright::measurement::replay {

/// Why numbers make no model, or no motion, as `make` finds when it is called: they break a rule of the physics
/// (std::invalid_argument), lead out of the range of a formula or of a curve (std::domain_error), or a solver finds
/// nothing with them (std::runtime_error). Nothing where `make` returns. All else is no property of numbers and goes on
/// to the caller: memory that is used up, what the system refuses (std::system_error), a mistake of the program.
[[nodiscard]] std::optional<std::string> refusal_of(const std::function<void()>& make);

/// What `make` returns, a Made or an optional of one; nothing where its numbers make no model or no motion. All fits,
/// replays and proposals ask for models and motions by this: a point without one is not gone to, and nothing else ends.
template <class Made, class Make>
[[nodiscard]] std::optional<Made> if_possible(const Make& make) {
  std::optional<Made> out;
  if (refusal_of([&] { out = make(); })) return std::nullopt;
  return out;
}

}  // namespace coilwright::measurement::replay
