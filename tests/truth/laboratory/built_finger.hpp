#pragma once

#include <string>
#include <vector>

#include "truth/finger.hpp"
#include "truth/laboratory/request.hpp"
#include "truth/random.hpp"

namespace truth::laboratory {

/// A declared number and what it really is.
struct Number {
  std::string name;    ///< key of measured-data/1's `tolerances`: a JSON pointer, or a name
  double declared{};   ///< in the unit of the declared file
  double is{};         ///< for force_curve: the rms error
  double tolerance{};  ///< one standard deviation from which it was drawn, or within which it should lie
  bool far = false;    ///< whether it was moved far outside
};

/// The finger on the bench.
struct BuiltFinger {
  Finger finger;
  double angle_scale = 1.0;  ///< of the camera
  std::vector<Number> numbers;
};

/// Draws stiffness and damping (calibrated: 2 to 8 and 3 to 12 % off), then the declared numbers. Within: half of the
/// fingers have masses, lengths, stiffnesses and curves from normal distributions with the tolerances, cut at two; the
/// other half a tip mass 6 to 8 % off, l_2 5 % longer, a second hinge 6 to 10 % softer and 3 to 4 % in the curve. Far:
/// one or two of five numbers are off by eight tolerances and more, which are then a quarter of the usual ones.
[[nodiscard]] BuiltFinger build_finger(Random& random, Deviation deviation, Tolerances tolerances);

/// Multiplies a number by a factor. Throws std::out_of_range for the name of none, and for force_curve.
void set_number(const std::string& name, double factor, Finger& finger);

}  // namespace truth::laboratory
