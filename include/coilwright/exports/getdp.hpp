#pragma once

#include <vector>

#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// The first coil and magnet that are neighbours, straight, for Gmsh and GetDP: pair_data.pro has their numbers,
/// pair.geo the geometry and mesh, pair.pro the field with the force by J x B and by Maxwell's stress, and pair.json is
/// what the command `force` takes. Throws std::invalid_argument where the model has no pair by its dimensions, or no
/// air between the two. What the files mean is in docs/exports/fields.md.
[[nodiscard]] std::vector<ExportedFile> getdp(const ModelSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
