#pragma once

namespace coilwright::winding {

/// A thousandth of an inch, in metres: the unit of American wire tables.
inline constexpr double mil = 25.4e-6;

}  // namespace coilwright::winding
