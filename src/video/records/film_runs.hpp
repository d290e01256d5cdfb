#pragma once

#include <string>
#include <vector>

#include "coilwright/video/records/film_records.hpp"

namespace coilwright::video {

/// The name of what a person can say, "start_deg", as the request's sentences have it.
[[nodiscard]] std::string called(const FilmsRequest& request, std::string name);

/// The sense in which the tip goes farthest from where it begins.
[[nodiscard]] OpeningSense sense_of(const FingerMotion& motion);

/// Angles of the tags: the bending angle of one tag, the joints' of more; rad, where tags are glued straight.
[[nodiscard]] std::vector<double> first_angles(const FingerMotion& motion, OpeningSense opens);

/// Fills in the runs of a film that was read, on the clock of its log where there is one, and appends to `guessed` what
/// was. `offsets`: rad, added to each angle. Throws text::InputError where log and film cannot be brought together.
void fill_runs(FilmRecord& record, const FilmsRequest& request, OpeningSense opens, const std::vector<double>& offsets,
               const simulation::CommandedInput* log, std::vector<std::string>& guessed);

/// Appends what a person should know of the camera of a film.
void advise_on_camera(const FilmsRequest& request, const FilmRecord& record, FilmRecords& records);

}  // namespace coilwright::video
