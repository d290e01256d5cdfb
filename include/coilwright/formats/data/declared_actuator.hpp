#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "coilwright/measurement/replay/tolerances.hpp"

namespace coilwright::formats {

/// The model that a data set declares, and a function that writes new numbers into its file.
struct DeclaredActuator {
  std::string name;                          ///< of the actuator
  measurement::replay::DeclaredModel model;  ///< keeps what it needs; build() may be called from many threads at once
  /// Returns the actuator with `calibration` (SI, one value per model.calibration, inside the bounds) and with
  /// `effects` beside those that its file declares; an effect replaces one of the same kind. A lumped model that is
  /// written and read back equals that of build() to the bit; stiffness and damping of a design go through factors that
  /// round. Throws std::invalid_argument if the numbers make no model.
  std::function<UpdatedActuator(std::span<const double> calibration, const std::vector<actuator::Effect>& effects)>
      updated;
};

/// The names of the numbers that may be calibrated, and their origin.
struct Calibrate {
  /// Names: `joint_stiffness`, `joint_damping`, or a JSON pointer to a number of the actuator file. The first two are
  /// one value for all joints; if the joints of a lumped model differ, it is their mean, and each keeps its ratio to
  /// it.
  std::span<const std::string> names;
  std::string file;                         ///< dataset.json, for errors about a name
  std::string_view pointer = "/calibrate";  ///< pointer to the list in it
  /// Standard deviations of the declared numbers.
  measurement::replay::Tolerances tolerances = measurement::replay::Tolerances::exact();
  std::string_view tolerances_pointer = "/tolerances";
};

/// Reads the declared model of a data set and finds the numbers that a fit may move: the calibrated ones in their order
/// (with a prior if `tolerances` name them too), then those with only a tolerance. Of the latter, defaults that no
/// motion can tell from another number are left out and listed in `held_exact`. A number with a default may be named
/// even if the file leaves it out. Throws InputError of the actuator file if that is at fault, and of the data set, at
/// the name, if a name leads nowhere, to no number or to one that no fit can move (a whole number, a choice), or if two
/// names mean the same. Its effects must be among `effects`, to whose kinds the result refers.
[[nodiscard]] DeclaredActuator read_declared_actuator(
    const std::filesystem::path& actuator, const Calibrate& calibrate,
    const actuator::EffectCatalogue& effects = actuator::standard_effects());

/// Parses the declared model from a text in memory; errors call it `file`.
[[nodiscard]] DeclaredActuator parse_declared_actuator(
    std::string_view text, std::string file, const Calibrate& calibrate,
    const actuator::EffectCatalogue& effects = actuator::standard_effects());

}  // namespace coilwright::formats
