#pragma once

#include <string>

#include "coilwright/formats/actuator/pair_file.hpp"

namespace coilwright::cli {

/// Says on standard error in which poses bodies are in the same place, as no two parts can be.
void warn_of_overlaps(const formats::PairFile& file, const std::string& name);

/// Throws InputError where bodies are in the same place of which the force would mean nothing: all but coils and round
/// magnets magnetised along their axis.
void require_apart(const formats::PairFile& file, const std::string& name);

/// Says on standard error where the plate is no mirror: where it would saturate, and where it ends too near.
/// Precondition: the file has a plate.
void warn_of_plate(const formats::PairFile& file, const std::string& name);

}  // namespace coilwright::cli
