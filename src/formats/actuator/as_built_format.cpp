#include "formats/actuator/as_built_format.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/mechanics/joint_vector.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::AsBuilt;
using actuator::CorrectionAxis;
using actuator::CorrectionVariable;
using actuator::TorqueCorrection;
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

constexpr std::size_t fewest_nodes = 3;
constexpr std::size_t most_nodes = 100;  // of one variable
constexpr Rule node_rule = Rule::between(-1e6, 1e6);
constexpr Rule torque_rule = Rule::between(-1e12, 1e12);

constexpr const char* torque_key = "torque_Nmm";
constexpr const char* linear_below_key = "linear_below_rad_s";
// For a person who opens the file.
constexpr const char* note =
    "Fitted to what no known effect explains. It holds between the first and the last value of each variable, and "
    "fades to nothing within a tenth of that range beyond.";

struct AxisKey {
  const char* key;
  CorrectionVariable variable;
};
constexpr std::array axis_keys = {AxisKey{"angle_deg", CorrectionVariable::angle},
                                  AxisKey{"rate_rad_s", CorrectionVariable::rate},
                                  AxisKey{"current_A", CorrectionVariable::current}};

std::vector<CorrectionAxis> read_axes(ObjectReader& in) {
  std::vector<CorrectionAxis> axes;
  for (const AxisKey& each : axis_keys) {
    const auto node = in.find(each.key);
    if (!node) continue;
    if (axes.size() == 2) throw node->error_without_value("must not stand beside two other variables");
    CorrectionAxis axis{.variable = each.variable,
                        .nodes = node->quantities(Length::from_to(fewest_nodes, most_nodes), node_rule)};
    for (std::size_t i = 1; i < axis.nodes.size(); ++i)
      if (axis.nodes[i] <= axis.nodes[i - 1]) throw node->elements()[i].error("must exceed the value before it");
    axes.push_back(std::move(axis));
  }
  if (axes.empty())
    throw in.node().error_without_value(R"(needs one or two of "angle_deg", "rate_rad_s", "current_A")");
  if (const auto below = in.find(linear_below_key)) {
    const double value = below->quantity(positive);
    bool found = false;
    for (CorrectionAxis& axis : axes) {
      if (axis.variable != CorrectionVariable::rate) continue;
      axis.linear_below = value;
      found = true;
    }
    if (!found) throw below->error_without_value("must stand beside \"rate_rad_s\"");
  }
  return axes;
}

std::vector<double> read_torques(ObjectReader& in, const std::vector<CorrectionAxis>& axes) {
  const Length rows = Length::exactly(axes[0].nodes.size());
  if (axes.size() == 1) return in.quantities(torque_key, rows, torque_rule);
  std::vector<double> torques;
  for (const Node& row : in.elements(torque_key, rows))
    for (const double torque : row.quantities(Length::exactly(axes[1].nodes.size()), torque_rule))
      torques.push_back(torque);
  return torques;
}

const char* key_of(CorrectionVariable variable) {
  for (const AxisKey& each : axis_keys)
    if (each.variable == variable) return each.key;
  return "";
}

// {"angle_deg": [..], "rate_rad_s": [..], "linear_below_rad_s": 0.5, "torque_Nmm": [[..], ..], "joint": 2} with one or
// two of angle_deg, rate_rad_s and current_A; a row of torques for each node of the first of them.
std::optional<TorqueCorrection> read_torque_correction(ObjectReader& in) {
  const auto node = in.find(torque_correction_key);
  if (!node) return std::nullopt;
  return read_object(*node, [](ObjectReader& keys) {
    (void)keys.text_or("note", "");
    TorqueCorrection out{.axes = read_axes(keys)};
    out.torques = read_torques(keys, out.axes);
    if (const auto joint = keys.find("joint"))
      out.joint = joint->integer<int>(Rule::between(1, mechanics::max_joints)) - 1;
    actuator::validate(out);
    return out;
  });
}

Json to_json(const TorqueCorrection& correction) {
  Json out = Json::object({{"note", note}});
  for (const CorrectionAxis& axis : correction.axes) {
    out.set(Json::quantities(key_of(axis.variable), axis.nodes));
    if (axis.linear_below) out.set(Json::quantity(linear_below_key, *axis.linear_below));
  }
  if (correction.joint) out.set("joint", *correction.joint + 1);
  const std::span<const double> torques(correction.torques);
  if (correction.axes.size() == 1) {
    out.set(Json::quantities(torque_key, torques));
    return out;
  }
  const std::size_t columns = correction.axes[1].nodes.size();
  Json rows = Json::array();
  for (std::size_t at = 0; at < torques.size(); at += columns)
    rows.add(Json::quantities(torque_key, torques.subspan(at, columns)).second);
  out.set(torque_key, std::move(rows));
  return out;
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
