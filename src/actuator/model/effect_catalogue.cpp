#include "coilwright/actuator/model/effect_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace coilwright::actuator {

EffectCatalogue::EffectCatalogue(std::vector<const EffectKind*> kinds) : kinds_(std::move(kinds)) {
  for (auto at = kinds_.begin(); at != kinds_.end(); ++at) {
    if (*at == nullptr) throw std::invalid_argument("effect catalogue: a kind must not be null");
    const std::string_view id = (*at)->id();
    if (id.empty()) throw std::invalid_argument("effect catalogue: an id must not be empty");
    if (std::any_of(kinds_.begin(), at, [&](const EffectKind* kind) { return kind->id() == id; }))
      throw std::invalid_argument(fmt::format("effect catalogue: an id may be there once; {} is there twice", id));
  }
  std::ranges::stable_sort(kinds_, {}, [](const EffectKind* kind) { return kind->stage(); });
}

EffectCatalogue EffectCatalogue::with(const EffectKind& kind) const {
  std::vector<const EffectKind*> kinds = kinds_;
  kinds.push_back(&kind);
  return EffectCatalogue(std::move(kinds));
}

const EffectKind* EffectCatalogue::find(std::string_view id) const {
  const auto found = std::ranges::find_if(kinds_, [&](const EffectKind* kind) { return kind->id() == id; });
  return found == kinds_.end() ? nullptr : *found;
}

}  // namespace coilwright::actuator
