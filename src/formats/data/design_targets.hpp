#pragma once

#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/measurement/replay/calibration_target.hpp"
#include "coilwright/text/json/document.hpp"
#include "formats/data/calibrate_names.hpp"

namespace coilwright::formats {

using DesignNumber = measurement::replay::CalibratableNumber<measurement::replay::DesignTarget>;

/// The numbers of `design` that `names` mean, in their order; `document` is its file and `spec` its nominal model.
/// Throws InputError at a name that means no number or one that no fit can move.
[[nodiscard]] std::vector<DesignNumber> design_numbers(const text::Document& document, const actuator::Design& design,
                                                       const actuator::ModelSpec& spec, CalibrateNames& names);

}  // namespace coilwright::formats
