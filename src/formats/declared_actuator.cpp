#include "coilwright/formats/declared_actuator.hpp"

#include <utility>

#include "actuator_reader.hpp"
#include "declared_parts.hpp"

namespace coilwright::formats {
namespace {

DeclaredActuator declared_by(Document document, const Calibrate& calibrate) {
  ActuatorContent read = read_actuator_content(document);
  CalibrateNames names(calibrate, document.root().file());
  DeclaredActuator out = std::visit(
      [&](auto& content) { return declare(std::move(document), std::move(content), std::move(names)); }, read.content);
  out.name = std::move(read.name);
  return out;
}

}  // namespace

DeclaredActuator read_declared_actuator(const std::filesystem::path& actuator, const Calibrate& calibrate) {
  return declared_by(read_json(actuator), calibrate);
}

DeclaredActuator parse_declared_actuator(std::string_view text, std::string file, const Calibrate& calibrate) {
  return declared_by(parse_json(text, std::move(file)), calibrate);
}

}  // namespace coilwright::formats
