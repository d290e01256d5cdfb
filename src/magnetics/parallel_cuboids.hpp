#pragma once

#include <optional>

#include "coilwright/magnetics/body.hpp"
#include "magnetics/charged_faces.hpp"

namespace coilwright::magnetics {

/// Force and torque on a block in the field of another whose edges are along its own, as wrench_on_faces(), in closed
/// form. Absent where one of the two is no block, their edges are not parallel, or rounding takes more than 1e-9 of the
/// force (blocks some four sizes apart); `error` is what rounding may take.
[[nodiscard]] std::optional<EstimatedWrench> wrench_of_parallel_cuboids(const Body& source, const Body& body);

}  // namespace coilwright::magnetics
