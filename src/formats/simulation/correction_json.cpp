#include "coilwright/formats/simulation/correction_json.hpp"

#include <string>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using text::Json;

const char* unit_of(actuator::CorrectionVariable variable) {
  switch (variable) {
    case actuator::CorrectionVariable::angle:
      return "_deg";
    case actuator::CorrectionVariable::rate:
      return "_rad_s";
    case actuator::CorrectionVariable::current:
      break;
  }
  return "_A";
}

}  // namespace

Json to_json(std::span<const simulation::CorrectionReach> reach) {
  Json out = Json::array();
  for (const simulation::CorrectionReach& each : reach) {
    Json entry = Json::object({{"variable", name_of(each.variable)}});
    const auto set = [&](const char* name, double value) {
      const std::string key = std::string(name) + unit_of(each.variable);
      entry.set(key, units::from_memory(value, key));
    };
    set("measured_from", each.measured_from);
    set("measured_to", each.measured_to);
    set("used_from", each.used_from);
    set("used_to", each.used_to);
    entry.set("beyond", each.is_beyond());
    out.add(std::move(entry));
  }
  return out;
}

}  // namespace coilwright::formats
