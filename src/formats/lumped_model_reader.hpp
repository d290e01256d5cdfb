#pragma once

#include "coilwright/actuator/model.hpp"
#include "coilwright/formats/object_reader.hpp"

namespace coilwright::formats {

/// The keys of `lumped-model/1` but format and name.
[[nodiscard]] actuator::Model read_lumped_model(ObjectReader& in);

}  // namespace coilwright::formats
