#pragma once

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// A word that data sets and planned experiments share, as `measurement::name_of` writes it. Throws InputError with the
/// legal ones.
[[nodiscard]] measurement::data::RunKind read_run_kind(const text::Node& node);
[[nodiscard]] measurement::data::Drive read_drive(const text::Node& node);
[[nodiscard]] measurement::data::Start read_start(const text::Node& node);
[[nodiscard]] measurement::data::InputHold read_input_hold(const text::Node& node);
/// The key "role": whether fits must not see a run. A still run need not have it, and is never held out.
[[nodiscard]] bool read_is_validate(text::ObjectReader& in, bool still);

/// The object that says what was changed on the rig.
[[nodiscard]] measurement::data::RigChange read_rig(const text::Node& node);

/// The same object: what was not changed is not there.
[[nodiscard]] text::Json rig_json(const measurement::data::RigChange& rig);

/// The keys "input_sigma", one number for all columns of the input or one each, in their unit, and
/// "input_correlation_s"; where they are absent, `usual`. Throws InputError.
[[nodiscard]] measurement::data::InputUncertainty read_input_uncertainty(
    text::ObjectReader& in, const measurement::data::InputUncertainty& usual = {});
/// Writes them where the input is not exact.
void add_input_uncertainty(text::Json& out, const measurement::data::InputUncertainty& uncertainty);

}  // namespace coilwright::formats
