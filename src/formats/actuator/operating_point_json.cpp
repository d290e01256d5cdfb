#include "coilwright/formats/actuator/operating_point_json.hpp"

namespace coilwright::formats {

text::Json to_json(const actuator::OperatingPoint& point) {
  return text::Json::object({{"current_A", point.current}, {"duty", point.duty}});
}

}  // namespace coilwright::formats
