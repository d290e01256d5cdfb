#pragma once

#include <span>

#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A coil and a magnet with the poses of the magnet as the file of the command `force`: read back, they are the same.
[[nodiscard]] text::Json to_json(const CoilAndMagnet& pair, std::span<const magnetics::Pose> poses);

}  // namespace coilwright::formats
