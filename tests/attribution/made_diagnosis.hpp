#pragma once

#include <memory>
#include <string>
#include <vector>

#include "attribution/score.hpp"
#include "formats/data/named_effect.hpp"

namespace attribution {

/// A kind of effect that has a name only; the same one for the same name.
inline const coilwright::testing::NamedEffect* named(const std::string& id) {
  static std::vector<std::unique_ptr<coilwright::testing::NamedEffect>> kinds;
  for (const auto& kind : kinds)
    if (kind->id() == id) return kind.get();
  kinds.push_back(std::make_unique<coilwright::testing::NamedEffect>(id, ""));
  return kinds.back().get();
}

inline coilwright::measurement::Diagnosis diagnosed(coilwright::measurement::Verdict verdict,
                                                    const std::vector<std::string>& effects,
                                                    const std::vector<std::vector<std::string>>& ambiguous = {}) {
  coilwright::measurement::Diagnosis diagnosis;
  diagnosis.verdict = verdict;
  for (const std::string& id : effects) diagnosis.effects.push_back({.kind = named(id), .parameters = {}});
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
  return score({.number = 0, .category = category, .request = {}}, hiding(hidden), diagnosis);
}

}  // namespace attribution
