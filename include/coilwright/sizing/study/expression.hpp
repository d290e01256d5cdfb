#pragma once

#include <stdexcept>
#include <string>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::sizing {

/// A quantity that a study computes from others.
struct Expression {
  std::string text;  ///< "grasp_force_N / mass_g": names of quantities, in the units of their names
  std::string name;  ///< name of the result, without a unit: letters, digits and "_", a letter first
  std::string unit;  ///< of the result: "N/g"; "1" for a plain number
  double scale = 0;  ///< an ordinary magnitude of the result; 0: that of the scales of its quantities
};

/// An expression names something that is no quantity.
class UnknownSymbol : public std::invalid_argument {
 public:
  /// The error for that symbol; what() names it.
  explicit UnknownSymbol(std::string symbol);
  [[nodiscard]] const std::string& symbol() const noexcept { return symbol_; }

 private:
  std::string symbol_;
};

/// Whether a text has the form of a name: a letter, then letters, digits and "_".
[[nodiscard]] bool is_name(const std::string& text);

/// The quantity of an expression over `quantities`, under its name with its unit at the end: "grip_per_mass_N_g".
///
/// The language is muParser's: + - * / ^, brackets, comparisons, && and ||, `condition ? a : b`, and functions such as
/// sqrt, abs, min, max, exp, ln, log10, sin, cos, atan2 (radians). The decimal point is ".", whatever the locale. The
/// result has no value if a quantity in it has none, or if it is not finite (a division by zero).
///
/// Throws UnknownSymbol, and std::invalid_argument naming the rule: for bad syntax, an expression without a quantity,
/// an assignment, more than one result, an invalid name or unit, a scale that is not finite and >= 0.
[[nodiscard]] simulation::ResultQuantity expression_quantity(const Expression& expression,
                                                             const simulation::QuantityTable& quantities);

}  // namespace coilwright::sizing
