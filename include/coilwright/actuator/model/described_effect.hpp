#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::actuator {

/// An effect as a row of a table. Each field answers the function of EffectKind of its name. The texts are not copied,
/// so give literals.
struct EffectProperties {
  std::string_view id;
  Stage stage{};
  std::string_view description;
  std::string_view equation;
  std::string_view source;
  std::string_view check{};
  std::vector<EffectParameter> parameters{};
  bool needs_closed_circuit{};
  /// The same effect with further numbers (EffectKind::with_further_numbers). Not owned.
  const EffectKind* further{};
  std::function<std::vector<std::vector<double>>(const RigScale&)> starts{};
  /// Builds the effect (EffectKind::build). It is not called if the first number that has an `absent` value has that
  /// value.
  std::function<std::unique_ptr<const EffectTerm>(std::span<const double>, ModelSpec&)> build{};
  /// Why the effect cannot be in a model (EffectKind::inapplicable). Empty: it can be in every model.
  std::function<std::optional<std::string>(const ModelSpec&)> inapplicable{};
};

/// An effect that is such a row. With it a program defines an effect without a class of its own.
class DescribedEffect : public EffectKind {
 public:
  /// Keeps the row.
  explicit DescribedEffect(EffectProperties properties) : properties_(std::move(properties)) {}

  [[nodiscard]] std::string_view id() const final { return properties_.id; }
  /// These functions return the fields of the row.
  [[nodiscard]] Stage stage() const final { return properties_.stage; }
  [[nodiscard]] std::string_view description() const final { return properties_.description; }
  [[nodiscard]] std::string_view equation() const final { return properties_.equation; }
  [[nodiscard]] std::string_view source() const final { return properties_.source; }
  [[nodiscard]] std::string_view check() const final { return properties_.check; }
  [[nodiscard]] std::span<const EffectParameter> parameters() const final { return properties_.parameters; }
  [[nodiscard]] bool needs_closed_circuit() const final { return properties_.needs_closed_circuit; }
  [[nodiscard]] const EffectKind* with_further_numbers() const final { return properties_.further; }
  [[nodiscard]] std::optional<std::string> inapplicable(const ModelSpec& spec) const final;
  [[nodiscard]] std::vector<std::vector<double>> starts(const RigScale& scale) const final {
    return properties_.starts(scale);
  }
  [[nodiscard]] std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const final;

 private:
  EffectProperties properties_;
};

}  // namespace coilwright::actuator
