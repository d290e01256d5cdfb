#include "coilwright/formats/simulation/correction_json.hpp"

#include <string>

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
  return Json::list(reach, [](const simulation::CorrectionReach& each) {
    const std::string unit = unit_of(each.variable);
    return Json::object({{"variable", name_of(each.variable)},
                         Json::quantity("measured_from" + unit, each.measured_from),
                         Json::quantity("measured_to" + unit, each.measured_to),
                         Json::quantity("used_from" + unit, each.used_from),
                         Json::quantity("used_to" + unit, each.used_to),
                         {"beyond", each.is_beyond()}});
  });
}

}  // namespace coilwright::formats
