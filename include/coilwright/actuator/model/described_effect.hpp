#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::actuator {

/// What of an effect is text and numbers rather than code; each field as the function of EffectKind of its name.
struct EffectProperties {
  std::string_view id;
  Stage stage{};
  std::string_view description;
  std::string_view equation;
  std::string_view source;
  std::string_view check{};
  std::vector<EffectParameter> parameters{};
};

/// An effect whose texts and numbers are given once, in its constructor. What derives from it adds where a fit starts
/// and how the effect is built in. The texts are not copied: give literals.
class DescribedEffect : public EffectKind {
 public:
  /// Keeps the texts and numbers.
  explicit DescribedEffect(EffectProperties properties) : properties_(std::move(properties)) {}

  [[nodiscard]] std::string_view id() const final { return properties_.id; }
  /// As EffectKind says.
  [[nodiscard]] Stage stage() const final { return properties_.stage; }
  [[nodiscard]] std::string_view description() const final { return properties_.description; }
  [[nodiscard]] std::string_view equation() const final { return properties_.equation; }
  [[nodiscard]] std::string_view source() const final { return properties_.source; }
  [[nodiscard]] std::string_view check() const final { return properties_.check; }
  [[nodiscard]] std::span<const EffectParameter> parameters() const final { return properties_.parameters; }

 private:
  EffectProperties properties_;
};

}  // namespace coilwright::actuator
