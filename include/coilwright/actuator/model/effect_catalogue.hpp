#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::actuator {

/// The effects that a program knows: those that a reader of files accepts, a diagnosis compares and a list shows. An
/// immutable value; copies are cheap. It does not own the kinds: each must outlive the catalogue and every effect,
/// model and result that was made with it.
class EffectCatalogue {
 public:
  /// A catalogue without effects.
  EffectCatalogue() = default;

  /// Orders `kinds` by their stages, within one stage as given. Throws std::invalid_argument naming the id if a kind is
  /// null, has an empty id, or shares its id with another.
  explicit EffectCatalogue(std::vector<const EffectKind*> kinds);

  /// Returns this catalogue with one more kind, after the others of its stage: `standard_effects().with(my_effect)`.
  /// The argument must not be a temporary. Throws std::invalid_argument if its id is empty or already in the catalogue.
  [[nodiscard]] EffectCatalogue with(const EffectKind& kind) const;
  [[nodiscard]] EffectCatalogue with(const EffectKind&& kind) const = delete;

  /// Every kind, in the order of the stages.
  [[nodiscard]] std::span<const EffectKind* const> kinds() const noexcept { return kinds_; }

  /// The kind of that id; nullptr if there is none.
  [[nodiscard]] const EffectKind* find(std::string_view id) const;

 private:
  std::vector<const EffectKind*> kinds_;
};

/// The effects that Coilwright brings, in the order in which a model passes through them. A constant, whose kinds live
/// as long as the program.
[[nodiscard]] const EffectCatalogue& standard_effects();

}  // namespace coilwright::actuator
