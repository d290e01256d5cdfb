#pragma once

#include "coilwright/measurement/experiment/experiment.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::formats {

/// The object `input` of an experiment's run: one shape, whose levels end in the unit of the drive. Throws InputError.
[[nodiscard]] measurement::experiment::InputShape read_input_shape(const text::Node& node,
                                                                   measurement::data::Drive drive);

/// The object that reads back as this shape: a table as `levels`, whatever it was read from.
[[nodiscard]] text::Json input_shape_json(const measurement::experiment::InputShape& shape,
                                          measurement::data::Drive drive);

}  // namespace coilwright::formats
