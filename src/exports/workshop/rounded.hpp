#pragma once

namespace coilwright::exports {

/// The nearest number of six decimal digits: what a workshop can read, and a thousand times finer than it can work.
[[nodiscard]] double rounded(double value);

}  // namespace coilwright::exports
