#pragma once

#include <stdexcept>
#include <string>

namespace coilwright::text {

/// A fault of an input, in the order in which it is reported.
struct Fault {
  std::string file{};   ///< the path as the caller gave it
  std::string place{};  ///< JSON pointer, "line 3, column 7" or "line 12: column current_A"; empty: the file as a whole
  std::string rule{};   ///< the requirement, as the end of a sentence: "must be > 0"
  std::string value{};  ///< the value found, as it is shown; empty: none
};

/// An error for an input file that cannot be used. what() is one line, whatever the file holds: `study.json:
/// /variables/gap_mm/upper: must exceed lower (2); got 1.5`.
class InputError : public std::runtime_error {
 public:
  /// Writes the fault into one line.
  explicit InputError(Fault fault);
  [[nodiscard]] const Fault& fault() const noexcept { return fault_; }

 private:
  Fault fault_;
};

}  // namespace coilwright::text
