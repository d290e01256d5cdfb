#pragma once

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "attribution/score.hpp"

namespace attribution {

/// A name and nothing else.
class NamedKind final : public coilwright::actuator::EffectKind {
 public:
  explicit NamedKind(std::string id) : id_(std::move(id)) {}
  [[nodiscard]] std::string_view id() const override { return id_; }
  [[nodiscard]] coilwright::actuator::Stage stage() const override { return {}; }
  [[nodiscard]] std::string_view description() const override { return {}; }
  [[nodiscard]] std::string_view equation() const override { return {}; }
  [[nodiscard]] std::string_view source() const override { return {}; }
  [[nodiscard]] std::span<const coilwright::actuator::EffectParameter> parameters() const override { return {}; }
  [[nodiscard]] std::vector<std::vector<double>> starts(const coilwright::actuator::RigScale&) const override {
    return {};
  }
  [[nodiscard]] std::unique_ptr<const coilwright::actuator::EffectTerm> build(
      std::span<const double>, coilwright::actuator::ModelSpec&) const override {
    return nullptr;
  }

 private:
  std::string id_;
};

/// The same kind for the same name.
inline const NamedKind* named(const std::string& id) {
  static std::vector<std::unique_ptr<NamedKind>> kinds;
  for (const auto& kind : kinds)
    if (kind->id() == id) return kind.get();
  kinds.push_back(std::make_unique<NamedKind>(id));
  return kinds.back().get();
}

inline coilwright::measurement::Diagnosis diagnosed(coilwright::measurement::Verdict verdict,
                                                    const std::vector<std::string>& effects,
                                                    const std::vector<std::vector<std::string>>& ambiguous = {}) {
  coilwright::measurement::Diagnosis diagnosis;
  diagnosis.verdict = verdict;
  for (const std::string& id : effects)
    diagnosis.effects.push_back({.kind = named(id), .parameters = {}, .evidence = {}});
  for (const auto& set : ambiguous) {
    auto& kinds = diagnosis.indistinguishable.emplace_back();
    for (const std::string& id : set) kinds.push_back(named(id));
  }
  return diagnosis;
}

inline truth::Answer hiding(const std::vector<std::string>& ids) {
  truth::Answer answer{.noise = 0.005};
  for (const std::string& id : ids) {
    truth::HiddenEffect effect;
    effect.id = id;
    effect.visible = true;
    answer.hidden.push_back(effect);
  }
  return answer;
}

inline Outcome outcome_of(Category category, const std::vector<std::string>& hidden,
                          const coilwright::measurement::Diagnosis& diagnosis) {
  return score({.number = 0, .category = category, .order = {}}, hiding(hidden), diagnosis);
}

}  // namespace attribution
