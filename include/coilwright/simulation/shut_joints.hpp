#pragma once

#include <string>
#include <vector>

#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::simulation {

/// The cause that presses together the faces of joints that are shut at the operating point (or without current, if
/// none is under it), as the end of a sentence: the magnets that attract each other, with their force in N and that of
/// a coil on its magnet; the coil that pulls; or the weight. Empty if every joint is open, and if an effect is the
/// cause.
[[nodiscard]] std::string what_shuts_joints(const DesignView& design);

/// A change of a design or of its current after which every joint is open under current.
struct OpeningChange {
  /// The thing that changes: polarities of the row, its parts, or the current.
  enum class Of { polarity, row, current };
  Of of{};                 ///< the thing that changes
  std::string parts{};     ///< the parts that are turned round, "magnet 2 and coil 3"; empty for other changes
  EvaluatedDesign result;  ///< the design with the change, at a changed operating point if the current changes
};

/// For a design with joints that are shut under its current, the changes that open all of them: the polarity that turns
/// the fewest parts and the one with the largest stroke (those that leave no joint shut without current come first);
/// the row without the second of two magnets that attract, and with more coils between them; the smallest current of
/// either sign, whether or not the parts bear it. Each was evaluated as it would be built. Empty if no joint is shut
/// under current, and if none of these changes opens them.
[[nodiscard]] std::vector<OpeningChange> what_opens_joints(const DesignView& design);

}  // namespace coilwright::simulation
