#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/simulation/commanded_input.hpp"
#include "coilwright/video/finger_motion.hpp"

namespace coilwright::cli {

/// Which way a finger opens, as seen in the picture.
enum class OpeningSense { clockwise, counterclockwise };

/// What a person says of all films of a set.
struct AngleConvention {
  OpeningSense opens{};
  std::vector<double> start{};  ///< rad, angles at the beginning of the first film; empty: tags are glued straight
};

/// A film as runs of a data set.
struct FilmRuns {
  measurement::data::Run motion{};
  std::vector<double> sigmas{};                   ///< rad, of each sample of it
  std::optional<measurement::data::Run> still{};  ///< what came before it moved
  std::string clock{};                            ///< how the two clocks were brought together, a sentence
  std::string why_no_still{};                     ///< a sentence; empty where there is one
};

/// The sense in which the tip goes farthest from where it begins.
[[nodiscard]] OpeningSense sense_of(const video::FingerMotion& motion);

/// Angles of the tags: the bending angle of one tag, the joints' of more. In rad, by the convention without `start`.
[[nodiscard]] std::vector<double> first_angles(const video::FingerMotion& motion, OpeningSense opens);

/// The runs of a film, on the clock of its log where there is one. `name` is that of its files, without an ending.
/// `offsets`: rad, added to each angle. `led`: its place, px, where one sets the clock. Throws text::InputError where
/// log and film cannot be brought together.
[[nodiscard]] FilmRuns film_runs(const std::string& name, const video::TrackedFilm& film,
                                 const video::FingerMotion& motion, OpeningSense opens,
                                 const std::vector<double>& offsets,
                                 const std::optional<simulation::CommandedInput>& log,
                                 const std::optional<video::Place>& led);

}  // namespace coilwright::cli
