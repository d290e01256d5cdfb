#pragma once

#include <vector>

#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// The chain as URDF, actuator.urdf, with what URDF has no words for beside it: springs and stops in joints.csv, torque
/// per ampere in torque.csv. The springs are in the file too, as the extension that Gazebo reads. Left out are what
/// PlainModel leaves out, and inertia about the axes in the plane. What the files mean is in
/// docs/exports/simulators.md.
[[nodiscard]] std::vector<ExportedFile> urdf(const ModelSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
