#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/replay/calibration_target.hpp"
#include "formats/actuator/design_reader.hpp"

namespace coilwright::formats {

/// Why a number of the declared model may move.
enum class MovedBy {
  calibrate,   ///< the data set fits it anew
  tolerances,  ///< the data set says how well it is known
  defaults     ///< nothing is said of it
};

/// What of a difference from the file's own numbers a calibrated value is.
using Difference = std::variant<measurement::replay::ForceCurveNumber, measurement::replay::AsBuiltNumber>;

/// A number of the declared model that a fit may move: one calibration parameter.
struct PlannedNumber {
  std::string name;  ///< as in `calibrate`; of a difference, the parameter's key: "force_curve_1"
  MovedBy by{};
  std::string place{};                ///< in the data set, for errors; empty for a default
  std::string tolerance_place{};      ///< of its tolerance there; empty where none is named
  std::optional<double> deviation{};  ///< one standard deviation in the unit of the name; nothing: see `share`
  double share{};                     ///< one standard deviation over the declared number; 0: the number is free
  std::string_view effect{};          ///< see CalibrationParameter::effect
  std::optional<Difference> difference{};
  double declared{};  ///< of a difference, SI
};

/// All of them, in the order of the calibration parameters.
struct TolerancePlan {
  std::string file{};  ///< the data set, for errors
  std::vector<PlannedNumber> numbers{};
  std::vector<std::string> held_exact{};                    ///< what a report says of the others
  std::optional<actuator::TorqueCurveError> force_curve{};  ///< with its range, where a difference is of it
};

/// What may move where a data set says `said`; `drawn` is the model without what differs from it. Some of the defaults
/// may act alike. Throws InputError at a tolerance of what the model does not have.
[[nodiscard]] TolerancePlan tolerance_plan(const Calibrate& said, const DesignContent& content,
                                           const actuator::ModelSpec& drawn);
[[nodiscard]] TolerancePlan tolerance_plan(const Calibrate& said, const actuator::LumpedModel& model);

/// The parameter of a difference, without its tolerance.
[[nodiscard]] measurement::replay::CalibrationParameter difference_parameter(const PlannedNumber& number);

/// Gives `parameter`, found for `number`, its tolerance. Throws InputError where it exceeds a declared number that
/// cannot be negative: `file` is the plan's.
void set_tolerance(measurement::replay::CalibrationParameter& parameter, const PlannedNumber& number,
                   std::string_view file);

}  // namespace coilwright::formats
