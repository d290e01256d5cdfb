#pragma once

#include "coilwright/measurement/planning/experiment.hpp"
#include "coilwright/measurement/planning/instrument.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/node.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// The keys of an experiment about its instruments: `noise`, `resolution`, `noise_colour`, `hum`, `outliers`,
/// `input_noise`. Throws InputError.
[[nodiscard]] measurement::planning::Instruments read_instruments(text::ObjectReader& in);

/// Adds the keys that read back as these instruments; what an instrument does not have is not there. The unit of
/// `input_noise` is that of the drive.
void add_instruments(text::Json& out, const measurement::planning::Instruments& instruments,
                     measurement::data::Drive drive);

/// A number of every instrument under its key, in the unit of that.
[[nodiscard]] text::Json instruments_json(const measurement::planning::Instruments& instruments,
                                          double measurement::planning::Instrument::*what);

/// The object `input` of an experiment's run: one shape, whose levels end in the unit of the drive. Throws InputError.
[[nodiscard]] measurement::planning::InputShape read_input_shape(const text::Node& node,
                                                                 measurement::data::Drive drive);

/// The object that reads back as this shape: a table as `levels`, whatever it was read from.
[[nodiscard]] text::Json input_shape_json(const measurement::planning::InputShape& shape,
                                          measurement::data::Drive drive);

}  // namespace coilwright::formats
