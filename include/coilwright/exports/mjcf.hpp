#pragma once

#include <vector>

#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// The chain as a MuJoCo model, actuator.xml, and its torque per ampere as torque.csv and as custom data of the model:
/// links with inertias, joints with stiffness, damping and rest angle, stops where the faces meet, a motor for each
/// joint that takes its torque in N m. Left out are what PlainModel leaves out, and inertia about the axes in the
/// plane. What the files mean is in docs/exports/simulators.md.
[[nodiscard]] std::vector<ExportedFile> mjcf(const ModelSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
