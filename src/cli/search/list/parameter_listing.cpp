#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cli/packed_files.hpp"
#include "cli/search/list/listings.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/formats/actuator/parameter_rule.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

text::Document actuator_schema() {
  for (const PackedFile& file : schemas())
    if (file.name == "actuator.schema.json") return text::parse_json(file.text, std::string(file.name));
  throw std::logic_error("the schema of an actuator must be packed in");
}

std::string range_of(const actuator::Parameter& parameter) {
  if (!parameter.names().empty()) return fmt::format("{}", fmt::join(parameter.names(), ", "));
  return (parameter.whole ? "whole, " : "") + range_in_words(formats::rule_of(parameter));
}

// What the schema, of which tests hold every key and bound against the reader, says of it in a sentence.
std::string meaning_of(const actuator::Parameter& parameter, const text::Node& schema) {
  std::optional<text::Node> at = schema;
  for (const std::string_view step : {std::string_view("properties"), parameter.section, std::string_view("properties"),
                                      parameter.key, std::string_view("description")}) {
    at = at->find(step);
    if (!at) throw std::logic_error(fmt::format("the schema of an actuator must describe {}", parameter.name));
  }
  return at->text();
}

}  // namespace

Listing parameter_listing() {
  const text::Document schema = actuator_schema();
  Listing listing{.columns = {"key", "in_file", "unit", "range", "meaning"}, .rows = {}};
  for (const actuator::Parameter& parameter : actuator::parameters()) {
    const auto split = units::split_unit(parameter.key);
    listing.rows.push_back({std::string(parameter.name), fmt::format("/{}/{}", parameter.section, parameter.key),
                            split ? std::string(split->unit.suffix) : std::string(), range_of(parameter),
                            meaning_of(parameter, schema.root())});
  }
  return listing;
}

}  // namespace coilwright::cli
