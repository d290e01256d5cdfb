#pragma once

#include <string>
#include <vector>

#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// A model by its numbers alone, and what of it these cannot say.
struct LumpedNumbers {
  actuator::LumpedModel model;
  std::vector<std::string> left_out{};  ///< one line each
};

/// The links, joints, torque curves (as tables) and effects of `model`. A base tilt becomes the effect base_tilt, since
/// a lumped model has none of its own; differences as built are in the numbers. Left out are forces between parts that
/// are not neighbours, effects that need to know where the coils are, and the coils' resistance. Throws
/// std::invalid_argument for a base tilt beyond the 45 degrees of that effect.
[[nodiscard]] LumpedNumbers lumped_numbers(const actuator::Model& model);

/// The same as a `lumped-model/1`: lumped_model.json, whose description names what was left out.
[[nodiscard]] std::vector<ExportedFile> lumped(const ModelSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
