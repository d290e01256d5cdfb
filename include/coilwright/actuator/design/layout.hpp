#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coilwright::actuator {

enum class ComponentKind { coil, magnet };

/// One coil or magnet of an actuator, with the sense in which it is built in.
struct Component {
  ComponentKind kind{};
  /// +1 or -1. A coil of +1 at positive current repels a magnet of +1; reversing either reverses the sign.
  int polarity = 1;

  friend bool operator==(const Component&, const Component&) = default;
};

/// The row of components, base to tip. The first component sits in the fixed rear part, each further one in a segment
/// of its own.
using Layout = std::vector<Component>;

/// The four configurations of the source paper (its Fig. 2c, as the text reads).
enum class Configuration {
  A,  ///< coil, magnet
  B,  ///< coil, magnet, coil: the soft finger
  C,  ///< coil, magnet, coil, magnet, coil: magnets share the middle coil
  D   ///< coil, magnet, coil, coil, magnet, coil: two B in a row, with a joint between their coils
};

/// The letter of a configuration, "A" to "D".
[[nodiscard]] std::string_view name_of(Configuration configuration);

/// Layout of a configuration, every polarity +1.
[[nodiscard]] Layout layout_of(Configuration configuration);

/// A layout in words, base to tip, a minus before what is built in the other way: "coil -magnet coil".
[[nodiscard]] std::string text_of(const Layout& layout);

/// Throws std::invalid_argument naming the rule and the value received, unless the layout has 2 to max_joints + 1
/// components, polarities +1 or -1, at least one coil and one magnet, and no two magnets next to each other (no wall
/// keeps them apart).
void check_layout(const Layout& layout);

[[nodiscard]] int coil_count(const Layout& layout);
[[nodiscard]] int magnet_count(const Layout& layout);

}  // namespace coilwright::actuator
