#pragma once

#include <vector>

#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// The parts and the tools to make them by as parametric OpenSCAD: mould.scad, its numbers in mm as variables on top.
/// Cast body, bottom layer, filling, coils, magnets; bobbin and its loose flange; lower and upper half of the mould; a
/// box that guides the knife. After the steps of the source paper's section IV; its Fig. 7 shows them, the shapes of
/// mould and bobbin are ours. Reads no setting. Throws std::invalid_argument where a calibrated axis lies so that the
/// parts do not fit into the body.
[[nodiscard]] std::vector<ExportedFile> mould(const DesignSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
