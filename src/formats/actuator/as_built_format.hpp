#pragma once

#include "coilwright/actuator/model/as_built.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// The key "as_built" of an actuator file, with what it leaves out as it was designed; nothing different where the file
/// has no such key.
[[nodiscard]] actuator::AsBuilt read_as_built(text::ObjectReader& in);

/// What read_as_built() reads back to the bit: of what differs.
[[nodiscard]] text::Json to_json(const actuator::AsBuilt& differences);

}  // namespace coilwright::formats
