#pragma once

#include <string>
#include <vector>

#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::simulation {

/// What presses the faces of the joints of a design together that are shut at its operating point, or without current
/// where none is under it, as the end of a sentence: which magnets attract each other with how many N, against what a
/// coil gives its magnet; which coil pulls; or the weight. Empty where every joint is open, and where an effect does
/// it.
[[nodiscard]] std::string what_shuts_joints(const DesignView& design);

/// A change of a design or of its current by which every joint is open under current.
struct OpeningChange {
  /// What is changed: how parts of the row are built in, which parts it has, or what flows.
  enum class Of { polarity, row, current };
  Of of{};                 ///< which of these
  std::string parts{};     ///< those that are turned round, "magnet 2 and coil 3"; empty where it is no polarity
  EvaluatedDesign result;  ///< with the change, at an operating point of its own where that changes
};

/// For a design with joints that are shut under its current, the changes that open all of them: the polarity that turns
/// the fewest parts and the one of the largest stroke, those that leave no joint shut without current before those that
/// do; the row without the second of two magnets that attract, and with more coils between them; the smallest current,
/// of either sign and whether or not the parts bear it. Each was evaluated as it would be built. Empty where no joint
/// is shut under current, and where nothing of this opens them.
[[nodiscard]] std::vector<OpeningChange> what_opens_joints(const DesignView& design);

}  // namespace coilwright::simulation
