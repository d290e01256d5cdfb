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

/// The model that a data set declares, and the way back into its file.
struct DeclaredActuator {
  std::string name;                          ///< of the actuator
  measurement::replay::DeclaredModel model;  ///< keeps what it needs; build() may be called from many threads at once
  /// The actuator with `calibration` (SI, one value per model.calibration, inside the bounds) and `effects` beside
  /// those that its file declares; one of a kind that is there already takes its place. A lumped model that is written
  /// and read back is build()'s to the bit; a design's stiffness and damping go through factors that round. Throws
  /// std::invalid_argument where the numbers make no model.
  std::function<UpdatedActuator(std::span<const double> calibration, const std::vector<actuator::Effect>& effects)>
      updated;
};

/// The names of the numbers that may be calibrated, and where they are from.
struct Calibrate {
  /// `joint_stiffness`, `joint_damping`, or a JSON pointer to a number of the actuator file. The two are one value for
  /// all joints; where a lumped model's joints differ, it is their mean, and each keeps its ratio to it.
  std::span<const std::string> names;
  std::string file;                         ///< dataset.json, for errors about a name
  std::string_view pointer = "/calibrate";  ///< of the list in it
  /// How well the declared numbers are known.
  measurement::replay::Tolerances tolerances = measurement::replay::Tolerances::exact();
  std::string_view tolerances_pointer = "/tolerances";
};

/// Reads the declared model of a data set and finds the numbers that a fit may move in it: those that are calibrated in
/// their order (with a prior where `tolerances` name them too), then those that are known within a tolerance only.
/// Among the latter those of defaults that no motion can tell from another one are left out, which `held_exact` says. A
/// number that the file leaves out and that has a default can be named too. Throws InputError: of the actuator file
/// where that is at fault; of the data set, at the name, where it leads nowhere, to no number or to one that no fit can
/// move (a whole number, a choice), and where two names mean the same. Its effects are of `effects`, whose kinds the
/// result refers to.
[[nodiscard]] DeclaredActuator read_declared_actuator(
    const std::filesystem::path& actuator, const Calibrate& calibrate,
    const actuator::EffectCatalogue& effects = actuator::standard_effects());

/// The same for a text in memory; `file` is the name its errors carry.
[[nodiscard]] DeclaredActuator parse_declared_actuator(
    std::string_view text, std::string file, const Calibrate& calibrate,
    const actuator::EffectCatalogue& effects = actuator::standard_effects());

}  // namespace coilwright::formats
