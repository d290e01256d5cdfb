#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::actuator {

/// The effects that a program knows: what a reader of files accepts, what a diagnosis compares, what a list shows. An
/// immutable value; copies are cheap. It does not own the kinds: each must live longer than the catalogue and than
/// every effect, model and result that was made with it.
class EffectCatalogue {
 public:
  /// No effect at all.
  EffectCatalogue() = default;

  /// `kinds` in the order of their stages; within one stage in the order given. Throws std::invalid_argument naming the
  /// id where one is null, has an empty id, or shares its id with another.
  explicit EffectCatalogue(std::vector<const EffectKind*> kinds);

  /// This catalogue and one kind more, after the others of its stage: `standard_effects().with(my_effect)`. The
  /// argument must not be a temporary. Throws std::invalid_argument where its id is empty or already in the catalogue.
  [[nodiscard]] EffectCatalogue with(const EffectKind& kind) const;
  [[nodiscard]] EffectCatalogue with(const EffectKind&& kind) const = delete;

  /// Every kind, in the order of the stages.
  [[nodiscard]] std::span<const EffectKind* const> kinds() const noexcept { return kinds_; }

  /// The kind of that id; nullptr if there is none.
  [[nodiscard]] const EffectKind* find(std::string_view id) const;

 private:
  std::vector<const EffectKind*> kinds_;
};

/// The effects that Coilwright brings, in the order in which a model passes through them. A constant: nothing can be
/// added to it, and its kinds live as long as the program.
[[nodiscard]] const EffectCatalogue& standard_effects();

}  // namespace coilwright::actuator
