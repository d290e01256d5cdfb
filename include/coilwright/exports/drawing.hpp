#pragma once

#include <vector>

#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// The straight actuator with dimensions, in longitudinal section and in cross-sections through a coil and a magnet:
/// drawing.svg at the largest scale that fits on A4 across, and drawing.dxf (release 12, ASCII) at its own size, in mm.
/// Takes any design; reads no setting.
[[nodiscard]] std::vector<ExportedFile> drawing(const DesignSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
