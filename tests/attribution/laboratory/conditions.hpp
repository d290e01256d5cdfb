#pragma once

#include <span>
#include <string>
#include <vector>

#include "truth/laboratory/request.hpp"
#include "truth/random.hpp"

namespace attribution::laboratory {

/// One way in which records of a laboratory differ from clean ones, at its usual strength.
struct Condition {
  std::string name;
  /// Writes it into a request; what it leaves open is drawn.
  void (*impose)(truth::Random&, truth::laboratory::Request&);
};

/// Faults that combine with each other: declared numbers, clocks, noise, outliers, noisy inputs, faces, exposure.
[[nodiscard]] std::span<const Condition> faults();

/// Faults that only come alone: other kinds of the same.
[[nodiscard]] std::span<const Condition> single_faults();

/// Frame rates with half of the time exposed, and programmes other than the paper's.
[[nodiscard]] std::span<const Condition> cameras_and_programmes();

/// By name. Throws std::out_of_range for an unknown one.
[[nodiscard]] const Condition& condition(const std::string& name);

}  // namespace attribution::laboratory
