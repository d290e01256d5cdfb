#pragma once

#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::replay {

/// The model on a rig that was changed for one run: its base turned, a weight hung at the tip (a point mass at the end
/// of the last link, on its hinge line), the circuit of the coils open. What an open
/// circuit takes away is EffectKind::needs_closed_circuit()'s to say; that no current flows is the input's
/// (current_flows()).
[[nodiscard]] actuator::ModelSpec on_changed_rig(actuator::ModelSpec spec, const data::RigChange& change);

/// Whether the driver's current flows; otherwise the coils have none, whatever is commanded.
[[nodiscard]] bool current_flows(const data::RigChange& change);

}  // namespace coilwright::measurement::replay
