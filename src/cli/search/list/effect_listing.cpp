#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "cli/search/list/listings.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/parameter_rule.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using actuator::EffectKind;
using actuator::EffectParameter;

// In the unit of its key, as files give it; "must be >= 0" as a range is ">= 0".
std::string range_of(const EffectParameter& parameter) {
  if (!parameter.choices.empty()) {
    std::vector<double> choices;
    for (const double choice : parameter.choices) choices.push_back(units::from_memory(choice, parameter.key));
    return fmt::format("{}", fmt::join(choices, " or "));
  }
  return range_in_words(formats::rule_of(parameter));
}

void add_numbers(Listing& listing, const EffectKind& kind) {
  for (const EffectParameter& each : kind.parameters()) {
    const auto split = units::split_unit(each.key);
    listing.rows.push_back({std::string(kind.id()), std::string(each.key),
                            split ? std::string(split->unit.suffix) : std::string(), range_of(each),
                            std::string(each.text)});
  }
}

}  // namespace

Listing effect_listing() {
  Listing listing{.columns = {"effect", "key", "unit", "range", "meaning"}, .rows = {}};
  for (const EffectKind* kind : actuator::standard_effects().kinds()) {
    listing.rows.push_back({std::string(kind->id()), {}, {}, {}, std::string(kind->description())});
    // With what it may have besides: the kind that has all of them repeats its own.
    const EffectKind* further = kind->with_further_numbers();
    add_numbers(listing, further == nullptr ? *kind : *further);
  }
  return listing;
}

}  // namespace coilwright::cli
