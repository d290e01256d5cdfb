#include "attribution/laboratory/conditions.hpp"

#include <array>
#include <stdexcept>

#include "degree.hpp"

namespace attribution::laboratory {
namespace {

using namespace truth::laboratory;
using truth::Random;

constexpr double jitter = 1e-4;  // s, of a camera without a trigger

void numbers(Random& random, Request& request) {
  request.deviation = Deviation::within;
  request.tolerances = random.uniform() < 0.7 ? Tolerances::listed : Tolerances::absent;
}

void far_numbers(Random& random, Request& request) {
  request.deviation = Deviation::far;
  request.tolerances = random.uniform() < 0.7 ? Tolerances::listed : Tolerances::absent;
}

void clocks(Random& random, Request& request) {
  request.clocks.log = random.uniform() < 0.5 ? InputLog::own_samples : InputLog::every_change;
  request.clocks.smallest_offset = 0.005;
  request.clocks.largest_offset = 0.015;
  request.clocks.latest_start = 0.05;
  request.clocks.rate = random.uniform() < 0.5 ? 0.005 : 0.0;
}

void colour(Random& random, Request& request) {
  static constexpr std::array colours{Colour::low_passed, Colour::pink, Colour::hum};
  request.noise.colour = colours[random.below(3)];
  request.noise.still_run = true;
  request.noise.sigma_given = random.uniform() < 0.5;
}

void outliers(Random& random, Request& request) {
  request.noise.outliers = random.uniform(0.01, 0.05);
}

void noisy_input(Random& /*random*/, Request& request) {
  request.noise.input_noise = 0.02;
}

void faces(Random& random, Request& request) {
  request.faces = random.uniform() < 0.6 ? DeclaredFaces::absent : DeclaredFaces::elsewhere;
  if (request.tolerances == Tolerances::exact) request.tolerances = Tolerances::listed;  // nobody vouches for the faces
}

void exposure(Random& random, Request& request) {
  request.camera.frame_rate = random.uniform() < 0.5 ? 60.0 : 120.0;
  request.camera.exposure_share = random.uniform(0.3, 0.8);
  request.camera.jitter = jitter;
}

template <int rate>
void logged_at(Random& /*random*/, Request& request) {
  request.camera.frame_rate = rate;
  request.clocks.log = InputLog::beside_pictures;
}

template <Colour kind>
void coloured_at_rest(Random& /*random*/, Request& request) {  // seen in parts at rest alone
  request.noise.colour = kind;
  request.noise.sigma_given = true;
}

template <int rate>
void filmed_at(Random& /*random*/, Request& request) {
  request.camera = {.frame_rate = rate, .exposure_share = 0.5, .jitter = jitter};
}

template <Programme programme>
void driven_as(Random& /*random*/, Request& request) {
  request.programme = programme;
}

void quiet_camera(Random& /*random*/, Request& request) {
  request.noise.level = 0.1 * degree;
}

}  // namespace

std::span<const Condition> faults() {
  static const std::array<Condition, 7> all{{{"numbers", numbers},
                                             {"clocks", clocks},
                                             {"colour", colour},
                                             {"outliers", outliers},
                                             {"noisy_input", noisy_input},
                                             {"faces", faces},
                                             {"exposure", exposure}}};
  return all;
}

std::span<const Condition> single_faults() {
  static const std::array<Condition, 6> all{{{"input_at_60_fps", logged_at<60>},
                                             {"input_at_120_fps", logged_at<120>},
                                             {"filtered_without_still_run", coloured_at_rest<Colour::low_passed>},
                                             {"hum_without_still_run", coloured_at_rest<Colour::hum>},
                                             {"quiet_camera", quiet_camera},
                                             {"far_numbers", far_numbers}}};
  return all;
}

std::span<const Condition> cameras_and_programmes() {
  static const std::array<Condition, 10> all{{{"30_fps", filmed_at<30>},
                                              {"60_fps", filmed_at<60>},
                                              {"120_fps", filmed_at<120>},
                                              {"240_fps", filmed_at<240>},
                                              {"500_fps", filmed_at<500>},
                                              {"few_runs", driven_as<Programme::few>},
                                              {"one_run", driven_as<Programme::one>},
                                              {"sines", driven_as<Programme::sines>},
                                              {"rig_changes", driven_as<Programme::rig_changes>},
                                              {"hold", driven_as<Programme::hold>}}};
  return all;
}

const Condition& condition(const std::string& name) {
  for (const auto& list : {faults(), single_faults(), cameras_and_programmes()})
    for (const Condition& each : list)
      if (each.name == name) return each;
  throw std::out_of_range("condition: must be one of the table; got " + name);
}

}  // namespace attribution::laboratory
