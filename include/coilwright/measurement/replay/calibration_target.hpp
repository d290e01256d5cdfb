#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/model/as_built.hpp"
#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::replay {

/// A number of an effect that the declared model has.
struct EffectNumber {
  std::size_t effect{};     ///< index among the effects of the model
  std::size_t parameter{};  ///< index among the parameters of its kind
};

/// One number of the hinges, with one value for all joints of a design.
struct HingesNumber {
  double actuator::Hinge::*member{};
};

/// A number of actuator::parameters(), not a whole one.
struct DesignParameter {
  const actuator::Parameter* parameter{};
};

/// A value measured on the built actuator, from which the calibration factors of the design follow.
struct MeasuredNumber {
  std::optional<double> actuator::Measured::*member{};
};

/// A coefficient of the error of the torque per ampere over the angle.
struct ForceCurveNumber {
  std::size_t order{};  ///< of its polynomial, 0 to 3
};

/// One number of what differs from the declared numbers: a value less `from`.
struct AsBuiltNumber {
  double actuator::AsBuilt::*member{};
  double from{};
};

/// Sets such a number of `differences`; the range of a curve's error must be there.
void set_number(actuator::AsBuilt& differences, const ForceCurveNumber& number, double value);
void set_number(actuator::AsBuilt& differences, const AsBuiltNumber& number, double value);

/// Which number of a design a calibrated value is.
using DesignTarget =
    std::variant<HingesNumber, EffectNumber, DesignParameter, MeasuredNumber, ForceCurveNumber, AsBuiltNumber>;

/// The gravity of a lumped model.
struct GravityNumber {};

/// One number of a part of a lumped model. `index` counts links or hinges from the base; for the dimensions of a coil,
/// of a magnet or of their places, it counts the pairs.
template <class Part>
struct PartNumber {
  std::size_t index{};
  double Part::*member{};
};

/// One number of a measured torque table.
struct TableNumber {
  std::size_t pair{};
  std::vector<double> actuator::TorqueTable::*column{};
  std::size_t row{};
};

/// One number of a lumped model.
using LumpedNumber =
    std::variant<EffectNumber, GravityNumber, PartNumber<mechanics::Link>, PartNumber<actuator::Hinge>,
                 PartNumber<mechanics::FaceContact>, PartNumber<magnetics::ThickCoil::Spec>,
                 PartNumber<magnetics::CylinderMagnet::Spec>, PartNumber<magnetics::HingeGeometry>, TableNumber>;

/// The place of that number in `model`, SI. The number must be one of `model`.
[[nodiscard]] double& number_in(actuator::LumpedModel& model, const LumpedNumber& number);

/// A number of a lumped model that is a calibrated value times `ratio`.
struct LumpedShare {
  LumpedNumber number;
  double ratio = 1.0;
};

/// The numbers of a lumped model that one calibrated value sets. A vector alone is no alternative of LumpedTarget: see
/// text::Variant, which this room does not know.
struct LumpedShares {
  std::vector<LumpedShare> each;
};

/// Which numbers of a lumped model a calibrated value sets: one, or for "joint_stiffness" and "joint_damping" one of
/// every hinge, each with its ratio to their mean; or what differs from all of them.
using LumpedTarget = std::variant<LumpedShares, ForceCurveNumber, AsBuiltNumber>;

/// A number that may be calibrated: what a fit must know of it, and where it belongs.
template <class Target>
struct CalibratableNumber {
  CalibrationParameter parameter;
  Target target;
};

/// What a fit must know of such numbers, in their order.
template <class Target>
[[nodiscard]] std::vector<CalibrationParameter> parameters_of(const std::vector<CalibratableNumber<Target>>& numbers) {
  std::vector<CalibrationParameter> out;
  for (const CalibratableNumber<Target>& number : numbers) out.push_back(number.parameter);
  return out;
}

/// Throws std::invalid_argument where there are more or fewer values than `numbers`.
void require_values(std::span<const double> values, std::size_t numbers);

}  // namespace coilwright::measurement::replay
