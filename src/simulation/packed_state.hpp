#pragma once

#include <boost/container/static_vector.hpp>
#include <boost/numeric/odeint/util/is_resizeable.hpp>
#include <boost/type_traits/integral_constant.hpp>
#include <cstddef>
#include <functional>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::simulation {

/// Angles, then rates, base to tip, then the effects' states (and the slopes of all three); no heap.
using PackedState = boost::container::static_vector<double, 2 * static_cast<std::size_t>(mechanics::max_joints) +
                                                                actuator::max_internal_states>;

/// Slopes of a whole state at one time.
using PackedDerivative = std::function<void(const PackedState& values, PackedState& slopes)>;

}  // namespace coilwright::simulation

template <>
struct boost::numeric::odeint::is_resizeable<coilwright::simulation::PackedState> : boost::true_type {};
