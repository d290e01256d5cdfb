#include "coilwright/formats/film/film_records_file.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/text/csv/csv_writer.hpp"

namespace coilwright::formats {
namespace {

using measurement::data::Run;
using text::Json;

constexpr double degree = std::numbers::pi / 180.0;

void write_motion(std::ostream& out, const Run& run, const std::vector<double>& sigmas) {
  std::vector<std::string> names{"time_s"};
  for (const auto& channel : run.channels) names.push_back(channel.name);
  if (!sigmas.empty()) names.emplace_back("sigma_deg");
  text::CsvWriter csv(out, names);
  const auto digits = [](double value, double ten_to_places) {
    return std::round(value * ten_to_places) / ten_to_places;
  };
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    std::vector<double> row{digits(run.times[i], 1e7)};
    for (const auto& channel : run.channels) row.push_back(digits(channel.values[i] / degree, 1e5));
    if (!sigmas.empty()) row.push_back(digits(sigmas[i] / degree, 1e5));
    csv.row(row);
  }
}

}  // namespace

void write_film_records(const video::FilmRecords& records,
                        const std::function<std::ostream&(const std::string& name)>& open) {
  for (const video::FilmRecord& film : records.films) {
    write_motion(open(film.run.name), film.run, film.sigmas);
    if (const auto input = input_file_name(film.run)) write_input(open(*input), film.run);
    if (film.still) write_motion(open(film.still->name), *film.still, {});
  }
}

Json dataset_json(const std::string& name, const std::string& actuator, const video::FilmRecords& records) {
  std::vector<RunWithRole> in_roles;
  for (const video::FilmRecord& film : records.films) {
    in_roles.push_back({.run = film.run});
    if (film.still) in_roles.push_back({.run = *film.still});
  }
  Json document = dataset_json(name, actuator, in_roles);
  document.set("ignore", Json::array({"sigma_deg"}));
  return document;
}

Json to_json(const video::FilmRecords& records) {
  Json films = Json::list(records.films, [](const video::FilmRecord& film) {
    return Json::object({{"name", film.name},
                         {"pictures", film.film.pictures},
                         {"doubled", film.film.doubled},
                         {"unstamped", film.film.unstamped},
                         {"read", film.motion.tags.back().samples.size()},
                         {"interval_s", film.motion.interval},
                         {"exposure_s", film.motion.exposure.value},
                         {"readout_s", film.motion.readout.value},
                         {"tilt_deg", film.motion.tilt / degree},
                         {"view_bias_deg", film.motion.view_bias / degree}});
  });
  return Json::object({{"films", std::move(films)},
                       {"guessed", Json::list(records.guessed)},
                       {"to_be_said", Json::list(records.to_be_said)}});
}

}  // namespace coilwright::formats
