#pragma once

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::formats {

/// A word that data sets and planned experiments share, as `measurement::name_of` writes it. Throws InputError with the
/// legal ones.
[[nodiscard]] measurement::data::RunKind read_run_kind(const text::Node& node);
[[nodiscard]] measurement::data::Drive read_drive(const text::Node& node);
[[nodiscard]] measurement::data::Start read_start(const text::Node& node);
[[nodiscard]] measurement::data::InputHold read_input_hold(const text::Node& node);
[[nodiscard]] measurement::data::CoilWiring read_coil_wiring(const text::Node& node);
/// The object that says what was changed on the rig.
[[nodiscard]] measurement::data::RigChange read_rig(const text::Node& node);

}  // namespace coilwright::formats
