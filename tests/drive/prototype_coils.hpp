#pragma once

#include "coilwright/drive/coil_bank.hpp"

namespace coilwright::drive {

inline constexpr Circuit coils{.resistance = 7.6, .inductance = 2.33e-3};  // of the prototype, in series

}  // namespace coilwright::drive
