#include "formats/actuator/as_built_format.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "coilwright/units/unit.hpp"
#include "formats/actuator/torque_correction_format.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::AsBuilt;
using actuator::TorqueCurveError;

// Beyond, nothing is as it was designed.
constexpr Rule ratio_rule = Rule::between(-2.0, 2.0);
constexpr Rule angle_rule = Rule::between(-180.0, 180.0);  // deg
constexpr Rule coefficient_rule = Rule::between(-0.9, 9.0);

TorqueCurveError read_force_curve(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    TorqueCurveError error{.lower = in.quantity("from_deg", angle_rule), .upper = in.quantity("to_deg", angle_rule)};
    if (error.upper <= error.lower) throw in.at("to_deg").error("must exceed from_deg");
    const std::vector<double> values =
        in.numbers("coefficients", Length::exactly(error.coefficients.size()), coefficient_rule);
    std::ranges::copy(values, error.coefficients.begin());
    return error;
  });
}

}  // namespace

AsBuilt read_as_built(ObjectReader& in) {
  const std::optional<actuator::TorqueCorrection> correction = read_torque_correction(in);
  const auto node = in.find("as_built");
  if (!node) return {.torque_correction = correction};
  return read_object(*node, [&](ObjectReader& keys) {
    AsBuilt out{.torque_correction = correction};
    if (const auto curve = keys.find("force_curve")) out.force_curve = read_force_curve(*curve);
    out.joint_stiffness_ratio = keys.number_or("joint_stiffness_ratio", 0.0, ratio_rule);
    out.joint_damping_ratio = keys.number_or("joint_damping_ratio", 0.0, ratio_rule);
    out.face_closing_shift = keys.quantity_or("face_closing_shift_deg", 0.0, angle_rule);
    return out;
  });
}

void set_as_built(Json& file, const AsBuilt& differences) {
  if (differences.torque_correction) file.set(torque_correction_key, to_json(*differences.torque_correction));
  AsBuilt named = differences;
  named.torque_correction.reset();
  if (named == AsBuilt{}) return;
  Json out = Json::object();
  if (const auto& curve = differences.force_curve)
    out.set("force_curve",
            Json::object({Json::quantity("from_deg", curve->lower),
                          Json::quantity("to_deg", curve->upper),
                          {"coefficients", Json::numbers({curve->coefficients.begin(), curve->coefficients.end()})}}));
  if (differences.joint_stiffness_ratio != 0.0) out.set("joint_stiffness_ratio", differences.joint_stiffness_ratio);
  if (differences.joint_damping_ratio != 0.0) out.set("joint_damping_ratio", differences.joint_damping_ratio);
  if (differences.face_closing_shift != 0.0)
    out.set(Json::quantity("face_closing_shift_deg", differences.face_closing_shift));
  file.set("as_built", std::move(out));
}

}  // namespace coilwright::formats
