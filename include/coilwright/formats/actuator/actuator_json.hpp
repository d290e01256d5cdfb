#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/as_built.hpp"
#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::formats {

/// The content of a lumped model's file, with other numbers.
struct UpdatedLumpedModel {
  text::Document document;  ///< as it was read, with other numbers; its "effects" and "as_built" are ignored
  std::vector<actuator::Effect> effects;  ///< all effects of the model
  actuator::AsBuilt as_built{};
};

/// An actuator after a diagnosis, to be written by to_json().
using UpdatedActuator = std::variant<actuator::Design, UpdatedLumpedModel>;

/// The key "effects" of an actuator file. Reading it back gives the same effects.
[[nodiscard]] text::Json to_json(std::span<const actuator::Effect> effects);

/// The numbers of one effect under their keys: the content of "parameters".
[[nodiscard]] text::Json parameters_json(const actuator::Effect& effect);

/// A design as an `actuator/1` file, with every value, its calibration factors and its effects. Reading it back gives
/// the same design. If it has an operating point, `evaluate` takes that by default.
[[nodiscard]] text::Json to_json(const actuator::Design& design, const std::string& name,
                                 const std::optional<actuator::OperatingPoint>& operating_point = std::nullopt);

/// An actuator after a diagnosis, complete: a design under `name`, or a lumped model as its file was, with the new
/// numbers and all effects.
[[nodiscard]] text::Json to_json(const UpdatedActuator& actuator, const std::string& name);

/// A model given by its numbers as a `lumped-model/1` file under `name`, with a `description` for people (left out if
/// empty). Reading it back gives the same model to rounding. A table has angle_deg and torque_Nmm_A, a pair its
/// dimensions, a joint without a pair null. Throws std::invalid_argument if a pair has no joint among the links, or two
/// pairs have the same.
[[nodiscard]] text::Json to_json(const actuator::LumpedModel& model, const std::string& name,
                                 const std::string& description = "");

/// The key "operating_point" of an actuator file and of result.json, with every value. Reading it back gives the same
/// point.
[[nodiscard]] text::Json to_json(const actuator::OperatingPoint& point);
/// Reads the operating point of such a file: its conditions and "current_A", which is required. Throws
/// text::InputError.
[[nodiscard]] actuator::OperatingPoint read_operating_point(const text::Node& node);

}  // namespace coilwright::formats
