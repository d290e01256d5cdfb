#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/actuator/model/torque_correction.hpp"

namespace coilwright::measurement::correction {

/// One place of a correction.
struct CorrectionPlace {
  std::vector<double> at{};  ///< values of its variables, SI
  double torque{};           ///< N m
};

/// A torque without a name that was fitted to what no effect explains, and what it tells the person who will name it.
struct NamelessCorrection {
  actuator::TorqueCorrection torque{};
  /// The calibration and the declared numbers with it, SI, as DeclaredModel::build takes them, and the effects.
  std::vector<double> calibration{};
  std::vector<actuator::Effect> effects{};
  double rms{};        ///< of the torque over the samples of the fit runs and the joints, N m
  double explained{};  ///< share of the squared residual of the fit runs above the noise that it takes away
  /// The same of runs that were left out in turn, beside the model with the effects.
  double cross_validated_gain{};
  double degrees_of_freedom{};  ///< how many free numbers it is worth, after what its prior takes away
  /// Of a correction over two variables, what its best approximations by one, two, ... products of a function of the
  /// one and a function of the other have of its sum of squares; empty over one variable.
  std::vector<double> products{};
  CorrectionPlace largest{};   ///< of the nodes that the motion came near, where the torque is largest
  CorrectionPlace smallest{};  ///< where it is smallest: pressing the joint closed
};

/// Why there is none, or one.
struct CorrectionOutcome {
  std::optional<NamelessCorrection> found{};
  std::string reason{};  ///< why none was found, a sentence for people; empty where one was
};

}  // namespace coilwright::measurement::correction
