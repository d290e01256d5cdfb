#pragma once

#include "coilwright/measurement/data/dataset.hpp"

namespace coilwright::measurement::data {

/// For a set that names no validate run: seals every fourth run of each kind, from the second on, so that every kind
/// with at least two keeps some on both sides; their files are then in `held_out`. Does nothing where validate runs are
/// there, or no kind has two.
void hold_out(Dataset& data);

}  // namespace coilwright::measurement::data
