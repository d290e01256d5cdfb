#pragma once

#include <map>
#include <string>
#include <vector>

#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/measurement/replay/calibration_target.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/calibrate_names.hpp"

namespace coilwright::formats {

/// Where a number of a lumped model stands in its file.
struct NumberInFile {
  std::string pointer;
  units::Unit unit;
  measurement::replay::LumpedNumber number;
};

/// The numbers of a lumped model that may be calibrated.
struct LumpedNumbers {
  std::vector<measurement::replay::CalibratableNumber<measurement::replay::LumpedTarget>> numbers{};
  std::vector<NumberInFile> in_file{};  ///< all that they set, but for numbers of effects
};

/// The numbers of `model` that `names` mean, in their order; `document` is its file. Throws InputError at a name that
/// means no number or one that no fit can move.
[[nodiscard]] LumpedNumbers lumped_numbers(const text::Document& document, const actuator::LumpedModel& model,
                                           CalibrateNames& names);

/// `document` with those numbers as they are in `model`.
[[nodiscard]] text::Document with_numbers_of(const text::Document& document, const std::vector<NumberInFile>& in_file,
                                             actuator::LumpedModel model);

}  // namespace coilwright::formats
