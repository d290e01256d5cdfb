#pragma once

namespace coilwright::actuator {

/// Specific heat of copper, J/(kg K): CRC Handbook.
inline constexpr double copper_specific_heat = 385.0;

/// Specific heat of sintered NdFeB, J/(kg K): makers' tables.
inline constexpr double magnet_specific_heat = 460.0;

}  // namespace coilwright::actuator
