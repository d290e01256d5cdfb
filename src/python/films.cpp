#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/film/film_records_file.hpp"
#include "coilwright/formats/film/lens_file.hpp"
#include "coilwright/formats/simulation/commanded_input_file.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/rule.hpp"
#include "python/bindings.hpp"
#include "python/interruptible.hpp"
#include "python/json_objects.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;

struct StoppedFilm {};

template <class Value>
std::optional<Value> said_in(const py::dict& said, const char* name) {
  return said[name].cast<std::optional<Value>>();
}

double allowed(double value, const char* name, const text::Rule& rule) {
  if (rule.allows(value)) return value;
  throw text::InputError({.file = name, .rule = rule.text(), .value = fmt::format("{}", value)});
}

std::optional<double> number_in(const py::dict& said, const char* name, const text::Rule& rule, double unit) {
  const auto value = said_in<double>(said, name);
  return value ? std::optional(allowed(*value, name, rule) * unit) : std::nullopt;
}

// Numbers in the units of their names; logs as the text of a table and what errors call it.
video::FilmsRequest request_of(const std::vector<std::string>& films,
                               const std::vector<std::pair<std::string, std::string>>& logs, const py::dict& said) {
  using text::Rule;
  constexpr double degree = std::numbers::pi / 180.0;
  video::FilmsRequest out{
      .films = {films.begin(), films.end()},
      .camera = {.readout = number_in(said, "readout_ms", Rule::between(-1e3, 1e3), 1e-3),
                 .exposure = number_in(said, "exposure_ms", Rule::between(0, 1e3), 1e-3),
                 .frame_rate = number_in(said, "rate_Hz", text::positive.and_also(Rule::at_most(1e6)), 1.0)},
      .previews = said["preview"].cast<bool>(),
      .as_keywords = true};
  for (const auto& [text, origin] : logs) out.logs.push_back(formats::parse_commanded_input(text, origin));
  if (const auto lens = said_in<std::string>(said, "lens")) {
    out.camera.lens = formats::read_lens(*lens);
    out.lens_file = *lens;
  }
  if (const auto led = said_in<std::pair<double, double>>(said, "led"))
    out.led = video::Place(allowed(led->first, "led", Rule::between(0, 1e5)),
                           allowed(led->second, "led", Rule::between(0, 1e5)));
  if (const auto opens = said_in<std::string>(said, "opens"))
    out.opens = *opens == "clockwise" ? video::OpeningSense::clockwise : video::OpeningSense::counterclockwise;
  for (const double angle : said["start_deg"].cast<std::vector<double>>())
    out.start.push_back(allowed(angle, "start_deg", Rule::between(-360, 360)) * degree);
  return out;
}

// (dataset.json, the text of each file by its name, what the films showed, the same as text, pictures by their name)
py::tuple track(const std::string& name, const std::vector<std::string>& films,
                const std::vector<std::pair<std::string, std::string>>& logs, const py::dict& said) {
  video::FilmsRequest request = request_of(films, logs, said);
  const video::FilmRecords records = interruptible([&](const std::stop_token& stop) {
    request.at_picture = [&stop] {
      if (stop.stop_requested()) throw StoppedFilm{};
    };
    return read_film_records(video::load_vision(), request);
  });
  std::map<std::string, std::ostringstream> files;
  formats::write_film_records(records, [&](const std::string& file) -> std::ostream& { return files[file]; });
  py::dict texts, pictures;
  for (const auto& [file, text] : files) texts[py::str(file)] = text.str();
  for (const video::FilmRecord& film : records.films) {
    py::list shown;
    for (const std::string& png : film.previews) shown.append(py::bytes(png));
    if (!film.previews.empty()) pictures[py::str(film.name)] = shown;
  }
  return py::make_tuple(to_python(formats::dataset_json(name, "actuator.json", records)), texts,
                        to_python(formats::to_json(records)), summary_of(records), pictures);
}

}  // namespace

void bind_films(py::module_& module) {
  module.def("track", &track, py::arg("name"), py::arg("films"), py::arg("logs"), py::arg("said"));
}

}  // namespace coilwright::python
