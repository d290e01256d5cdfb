#pragma once

#include "coilwright/actuator/model/as_built.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// The key of an actuator file under which a torque without a name stands.
inline constexpr const char* torque_correction_key = "torque_correction";

/// The keys "as_built" and "torque_correction" of an actuator file, with what they leave out as it was designed;
/// nothing different where the file has neither.
[[nodiscard]] actuator::AsBuilt read_as_built(text::ObjectReader& in);

/// Sets the same keys of `file`, each where something differs: read back, they are the same.
void set_as_built(text::Json& file, const actuator::AsBuilt& differences);

}  // namespace coilwright::formats
