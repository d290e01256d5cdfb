#include "measurement/unanswered_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "coilwright/units/angle.hpp"
#include "measurement/declared_readings.hpp"
#include "measurement/fit/hypothesis.hpp"

namespace coilwright::measurement {
namespace {

constexpr double hardly = 0.05;                                   // of the declared model's motion
constexpr double least_motion = 1.0 / units::degrees_per_radian;  // less shows nothing

// What most readings stay within; a tenth of them may be outliers on either side.
double extent(std::vector<double> values) {
  const auto at = [&](double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, place);
    return *place;
  };
  return at(0.9) - at(0.1);
}

}  // namespace

std::vector<data::Warning> unanswered_runs(std::span<const data::Run> runs, const replay::DeclaredModel& declared) {
  const fit::Hypothesis as_declared(declared, {});
  std::vector<data::Warning> out;
  for (const data::Run& run : runs) {
    if (!is_motion_of_angles(run)) continue;
    const auto readings = declared_readings(run, declared, as_declared);
    if (!readings) continue;
    for (const DeclaredReadings& angle : *readings) {
      if (!is_angle(*angle.channel)) continue;
      const double seen = extent(angle.measured);
      const double expected = extent(angle.declared);
      if (expected < least_motion || seen > hardly * expected) continue;
      out.push_back({.run = run.name,
                     .text = fmt::format("{} keeps within {:.2g} deg where the declared model moves by {:.2g} deg: a "
                                         "coil, a wire, the driver or the camera may have been off. If so, leave the "
                                         "run out: a fit would explain it by effects that are not there. If the "
                                         "current did flow, something holds the finger",
                                         angle.channel->name, units::degrees_per_radian * seen,
                                         units::degrees_per_radian * expected)});
      break;
    }
  }
  return out;
}

}  // namespace coilwright::measurement
