#include "measurement/records/possible_clock.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "coilwright/measurement/records/record_slip.hpp"
#include "measurement/data/median_interval.hpp"
#include "measurement/records/other_readings.hpp"

namespace coilwright::measurement::records {
namespace {

constexpr double fastest_camera = 5e-4;  // s
constexpr double fastest_sensor = 5e-6;  // s; an oscilloscope at a potentiometer
// Fewer rows may be whole seconds by chance.
constexpr std::size_t fewest_counts = 10;

}  // namespace

bool is_of_a_camera(double interval) {
  return interval > fastest_camera && interval < slowest_camera;
}

void require_possible_clock(const data::Run& run) {
  if (run.times.size() < 3) return;
  const double interval = data::median_interval(run);
  if (interval < fastest_sensor) {
    std::vector<std::string> cures;
    for (const OtherReading& reading : other_readings(run))
      if (reading.of == OtherReading::Of::time && reading.of_input_clock && reading.column == "time_s" &&
          is_of_a_camera(reading.factor * interval))
        cures.push_back(fmt::format("{} if they are {} (a sample every {:.3g} s)", reading.remedy, reading.looks_like,
                                    reading.factor * interval));
    if (cures.empty()) cures.emplace_back("name the column by the unit of its numbers");
    throw RecordSlip(fmt::format("{}: time: has a sample every {:.3g} s, closer than any sensor of a motion: {}",
                                 run.name, interval, fmt::join(cures, ", or ")));
  }
  if (run.times.size() >= fewest_counts && counts_by_ones(run))
    throw RecordSlip(
        fmt::format("{}: time_s: counts by ones, as pictures and rows are numbered: {} if there are 60 a second, else "
                    "with one over your number",
                    run.name, frame_remedy(60.0)));
}

void require_possible_clocks(std::span<const data::Run> still) {
  for (const data::Run& run : still) require_possible_clock(run);
}

}  // namespace coilwright::measurement::records
