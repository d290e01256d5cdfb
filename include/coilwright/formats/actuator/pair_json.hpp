#pragma once

#include <span>

#include "coilwright/magnetics/body.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A coil and a magnet with the poses of the magnet as the file of the command `force`: read back, they are the same.
[[nodiscard]] text::Json to_json(const magnetics::DrivenCoil& coil, const magnetics::CylinderMagnet& magnet,
                                 std::span<const magnetics::Pose> poses);

}  // namespace coilwright::formats
