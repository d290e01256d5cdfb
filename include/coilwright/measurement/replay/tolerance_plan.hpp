#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/measurement/replay/calibration_target.hpp"
#include "coilwright/measurement/replay/tolerances.hpp"

namespace coilwright::measurement::replay {

/// Why a number of the declared model may move.
enum class MovedBy {
  calibrate,   ///< a person has it fitted anew
  tolerances,  ///< a person says how well it is known
  defaults     ///< nothing is said of it
};

/// What of a difference from the file's own numbers a calibrated value is.
using Difference = std::variant<ForceCurveNumber, AsBuiltNumber>;

/// A number of the declared model that a fit may move: one calibration parameter.
struct PlannedNumber {
  std::string name;  ///< as a person says it; of a difference, the parameter's key: "force_curve_1"
  MovedBy by{};
  std::optional<double> deviation{};  ///< one standard deviation in the unit of the name; nothing: see `share`
  double share{};                     ///< one standard deviation over the declared number; 0: the number is free
  std::string_view effect{};          ///< see CalibrationParameter::effect
  std::optional<Difference> difference{};
  double declared{};  ///< of a difference, SI
};

/// All of them, in the order of the calibration parameters.
struct TolerancePlan {
  std::vector<PlannedNumber> numbers{};
  std::vector<std::string> held_exact{};                    ///< what a report says of the others
  std::optional<actuator::TorqueCurveError> force_curve{};  ///< with its range, where a difference is of it
};

/// What may move of a design whose numbers `calibrated` are fitted anew and of whose others `said` is known:
/// docs/theory/measurement.md. `measured` are the values from which its calibration followed; `drawn` is its
/// nominal model without what differs from it. Some of the defaults may act alike. Throws ToleranceFault for a
/// tolerance of what the model does not have, and one of 0 of a number that is calibrated.
[[nodiscard]] TolerancePlan tolerance_plan(std::span<const std::string> calibrated, const Tolerances& said,
                                           const actuator::Design& design, const actuator::Measured& measured,
                                           const actuator::ModelSpec& drawn);
/// The same of a lumped model.
[[nodiscard]] TolerancePlan tolerance_plan(std::span<const std::string> calibrated, const Tolerances& said,
                                           const actuator::LumpedModel& model);

/// The numbers of the plan with their tolerances, without those that are exact: `in_file` are those that are no
/// differences, which stand before them in the plan. Throws ToleranceFault for a tolerance that exceeds a declared
/// number that cannot be negative.
[[nodiscard]] std::vector<CalibratableNumber<DesignTarget>> with_tolerances(
    std::vector<CalibratableNumber<DesignTarget>> in_file, const TolerancePlan& plan);
[[nodiscard]] std::vector<CalibratableNumber<LumpedTarget>> with_tolerances(
    std::vector<CalibratableNumber<LumpedTarget>> in_file, const TolerancePlan& plan);

/// The plan without those defaults that act as other numbers do in `model`, which was declared by it; what is said by
/// name stays.
[[nodiscard]] TolerancePlan without_duplicates(TolerancePlan plan, const DeclaredModel& model);

}  // namespace coilwright::measurement::replay
