#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/simulation/commanded_input.hpp"
#include "coilwright/video/finger_motion.hpp"
#include "coilwright/video/vision.hpp"

namespace coilwright::video {

/// Which way a finger opens, as seen in the picture.
enum class OpeningSense { clockwise, counterclockwise };

/// The films of a data set, and what a person says of them.
struct FilmsRequest {
  std::vector<std::filesystem::path> films{};      ///< one for each motion; at least one, with names that differ
  std::vector<simulation::CommandedInput> logs{};  ///< of the input, one for each film; or none
  CameraKnowledge camera{};
  std::string lens_file{};              ///< what errors call the lens
  std::optional<Place> led{};           ///< px, of an LED that is lit with the first step of each log
  std::optional<OpeningSense> opens{};  ///< otherwise as the tip of the first film goes farthest
  /// Angles at the beginning of the first film, one for each tag but the base's, rad; empty: tags are glued straight.
  std::vector<double> start{};
  bool previews{};  ///< whether a dozen pictures of each film are kept, with what was read drawn in
  /// Whether sentences call what a person can say by keywords of Python, start_deg, and not by options, --start-deg.
  bool as_keywords{};
  std::function<void()> at_picture{};  ///< called at every picture in which a tag is read, if given; may throw
};

/// A film as runs of a data set.
struct FilmRecord {
  std::string name{};  ///< of its files, without an ending: the film's
  TrackedFilm film{};
  FingerMotion motion{};
  measurement::data::Run run{};                   ///< on the clock of its log, where there is one
  std::vector<double> sigmas{};                   ///< rad, standard deviation of each sample of it (of the first angle)
  std::optional<measurement::data::Run> still{};  ///< what came before it moved
  std::vector<std::string> previews{};            ///< PNG
};

/// The records of films, and what a person should know of them.
struct FilmRecords {
  std::vector<FilmRecord> films{};
  std::vector<std::string> guessed{};     ///< sentences: what was taken from the films and should be checked
  std::vector<std::string> to_be_said{};  ///< sentences: what no film shows
};

/// Reads films: one tag beside the base's gives the bending angle, more give the angles of the joints. Throws
/// text::InputError in one line where a film cannot be read, or cannot be brought together with its log.
[[nodiscard]] FilmRecords read_film_records(const Vision& vision, const FilmsRequest& request);

/// The same for people: a line for each film, and the sentences.
[[nodiscard]] std::string summary_of(const FilmRecords& records);

}  // namespace coilwright::video
