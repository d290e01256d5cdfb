#pragma once

#include "cli/search/list/listing.hpp"

namespace coilwright::cli {

/// What `evaluate` prints and a study may ask for, and what the blocks of a study add.
[[nodiscard]] Listing quantity_listing();

/// The numbers of a design: what --set and the variables of a study are called, and where they stand in a file.
[[nodiscard]] Listing parameter_listing();

/// Each effect, and below it each of its numbers.
[[nodiscard]] Listing effect_listing();

/// The copper wires.
[[nodiscard]] Listing gauge_listing();

/// The grades of magnets.
[[nodiscard]] Listing magnet_listing();

/// How numbers of an actuator usually scatter.
[[nodiscard]] Listing spread_listing();

/// How far numbers of an actuator are known that were not measured on it.
[[nodiscard]] Listing width_listing();

/// The hardness of silicones and the modulus that goes with it.
[[nodiscard]] Listing silicone_listing();

}  // namespace coilwright::cli
