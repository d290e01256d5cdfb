#pragma once

#include <vector>

#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// The first coil and magnet that are neighbours, straight, as a script for FEMM 4.2: pair.lua draws them, solves the
/// field and prints the force; pair.json is what the command `force` takes. Throws as getdp(). What the files mean is
/// in docs/exports/fields.md.
[[nodiscard]] std::vector<ExportedFile> femm(const ModelSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
