#include "coilwright/formats/data/declared_actuator.hpp"

#include <string>
#include <vector>

#include "reads_or_refuses.hpp"

namespace {

using namespace coilwright;

const std::string lumped = R"({"format": "lumped-model/1",
  "links": [{"length_m": 0.1, "com_along_m": 0.1, "com_offset_m": 0.01, "mass_kg": 0.2, "inertia_kgm2": 0}],
  "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 0.001}],
  "magnetics": [{"angle_deg": [-10, 0, 30, 60], "torque_Nmm_A": [19, 17, 9, 4]}],
  "effects": [{"id": "dry_friction", "parameters": {"torque_Nmm": 1}}]})";

// The bytes are a name that may be calibrated; a name that is accepted must give a model and a file.
void declare(std::string_view text) {
  const std::vector<std::string> names = {std::string(text)};
  const auto declared = formats::parse_declared_actuator(lumped, "x", {.names = names, .file = "x"});
  const std::vector<double> values = {declared.model.calibration[0].declared};
  (void)declared.model.build(values);
  (void)declared.updated(values, {});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return coilwright::fuzz::reads_or_refuses(data, size, declare);
}
