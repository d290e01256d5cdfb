// Draws pictures of a finger by a scene (JSON) and a motion (CSV): grey, row after row, one after the other, to
// standard output.

#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "run_program.hpp"
#include "video/film_renderer.hpp"

namespace {

using nlohmann::json;

// time_s, then bending_angle_deg (half at each joint) or theta1_deg and theta2_deg; other columns are passed over.
film::Motion read_motion(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file + " cannot be read");
  std::string line;
  std::getline(stream, line);
  std::vector<std::string> names;
  std::stringstream header(line);
  for (std::string name; std::getline(header, name, ',');) names.push_back(name);
  film::Motion out;
  while (std::getline(stream, line)) {
    std::stringstream row(line);
    std::array<double, 2> angles{};
    double time = 0.0;
    std::string field;
    for (const std::string& name : names) {
      std::getline(row, field, ',');
      const double value = field.empty() ? 0.0 : std::stod(field);
      const double angle = value * M_PI / 180.0;
      if (name == "time_s") time = value;
      if (name == "bending_angle_deg") angles = {0.5 * angle, 0.5 * angle};
      if (name == "theta1_deg") angles[0] = angle;
      if (name == "theta2_deg") angles[1] = angle;
    }
    out.times.push_back(time);
    out.angles.push_back(angles);
  }
  if (out.times.empty()) throw std::runtime_error(file + " has no rows");
  return out;
}

template <class Value>
void take(const json& from, const char* key, Value& value) {
  if (from.contains(key)) value = from.at(key).get<Value>();
}

film::Scene scene_of(const json& from) {
  film::Scene out;
  take(from, "width", out.width);
  take(from, "height", out.height);
  take(from, "focal", out.focal);
  take(from, "distortion", out.distortion);
  take(from, "tilt", out.tilt);
  take(from, "px_per_mm", out.px_per_mm);
  take(from, "middle", out.middle);
  take(from, "rate", out.rate);
  take(from, "exposure", out.exposure);
  take(from, "readout", out.readout);
  take(from, "quarter_turns", out.quarter_turns);
  take(from, "optics", out.optics);
  take(from, "white", out.white);
  take(from, "noise", out.noise);
  take(from, "led", out.led);
  take(from, "segment_tag", out.segment_tag);
  take(from, "board", out.board);
  take(from, "seed", out.seed);
  return out;
}

// The scene's "pictures" are the numbers of those that are drawn, by its "rate".
int run(int argc, char** argv) {
  if (argc != 3) throw std::runtime_error("usage: render_film SCENE.json MOTION.csv > PICTURES");
  const json from = json::parse(std::ifstream(argv[1]));
  const film::Scene scene = scene_of(from);
  film::Renderer renderer(scene, read_motion(argv[2]));
  for (const int number : from.at("pictures")) {
    const std::vector<std::uint8_t> picture = renderer.render(number / scene.rate, number);
    std::fwrite(picture.data(), 1, picture.size(), stdout);
  }
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("render_film", [&] { return run(argc, argv); });
}
