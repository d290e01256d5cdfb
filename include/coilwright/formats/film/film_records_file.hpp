#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "coilwright/text/json/json.hpp"
#include "coilwright/video/records/film_records.hpp"

namespace coilwright::formats {

/// Writes the CSV files of the records of films: of each its run with the column sigma_deg, its input where it has a
/// log, and its still run. `open` gives the stream of the file of a name, to be written until the next is opened.
void write_film_records(const video::FilmRecords& records,
                        const std::function<std::ostream&(const std::string& name)>& open);

/// dataset.json of the records of films with their logs; `actuator` is the declared model's file, counted from the
/// set's folder.
[[nodiscard]] text::Json dataset_json(const std::string& name, const std::string& actuator,
                                      const video::FilmRecords& records);

/// What the films showed beside the records: of each film its numbers of pictures and of the camera, and the sentences.
[[nodiscard]] text::Json to_json(const video::FilmRecords& records);

}  // namespace coilwright::formats
