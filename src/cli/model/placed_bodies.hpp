#pragma once

#include <string>

#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/report/systems/pair_remarks.hpp"

namespace coilwright::cli {

/// Throws InputError where bodies are in the same place of which the force would mean nothing: all but coils and round
/// magnets magnetised along their axis.
void require_apart(const formats::PairFile& file, const std::string& name);

/// Says on standard error what has to be known of the bodies in file `name`.
void tell(const report::PairRemarks& remarks, const std::string& name);

}  // namespace coilwright::cli
