#pragma once

#include <numbers>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/effect.hpp"

namespace coilwright::actuator::effects {

/// SI value = value in the key's unit / denominator (docs/units.md).
inline constexpr double milli = 1e3;
inline constexpr double degrees = 180.0 / std::numbers::pi;

/// What of an effect is text and numbers rather than code.
struct Description {
  std::string_view id;
  Stage stage{};
  std::string_view missing;
  std::string_view equation;
  std::string_view source;
  std::vector<EffectParameter> parameters{};
};

/// An effect that is described once and for all; its file adds where a fit starts and how it is built in.
class DescribedEffect : public EffectKind {
 public:
  explicit DescribedEffect(Description description) : description_(std::move(description)) {}

  [[nodiscard]] std::string_view id() const final { return description_.id; }
  [[nodiscard]] Stage stage() const final { return description_.stage; }
  [[nodiscard]] std::string_view missing() const final { return description_.missing; }
  [[nodiscard]] std::string_view equation() const final { return description_.equation; }
  [[nodiscard]] std::string_view source() const final { return description_.source; }
  [[nodiscard]] std::span<const EffectParameter> parameters() const final { return description_.parameters; }

 private:
  Description description_;
};

}  // namespace coilwright::actuator::effects
