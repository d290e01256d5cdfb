#pragma once

#include <vector>

#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// What a workshop needs to build the actuator: workshop.html, one page without anything from outside that prints on
/// A4, with winding sheet, bill of materials, casting recipe, order of assembly and checks; and the same numbers as
/// winding.csv and layers.csv, materials.csv, casting.csv and assembly.csv. Reads lead_length, waste and
/// base_per_hardener. Throws std::invalid_argument where a calibrated axis lies so that the parts do not fit into the
/// body.
[[nodiscard]] std::vector<ExportedFile> workshop(const DesignSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
