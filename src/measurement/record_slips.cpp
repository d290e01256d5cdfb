#include "measurement/record_slips.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/measurement/record_slip.hpp"
#include "coilwright/units/angle.hpp"
#include "measurement/data/usual_interval.hpp"
#include "measurement/declared_angles.hpp"
#include "measurement/fit/hypothesis.hpp"

namespace coilwright::measurement {
namespace {

// Of the miss as written, and of the variation of the records: far from what any effect changes.
constexpr double far_better = 0.25;
constexpr double follows = 0.5;
// Times that count by whole numbers are a sign by themselves, and levels are followed at any rate.
constexpr double better = 0.7;
// So that a large set costs no more than a second.
constexpr std::size_t enough_runs = 24;
constexpr std::array frame_rates = {24.0,  25.0,  30.0,  50.0,  60.0,  90.0,  100.0, 120.0, 200.0,
                                    240.0, 250.0, 300.0, 400.0, 480.0, 500.0, 960.0, 1000.0};

// What the numbers of a record may have been meant as.
struct Slip {
  double angle = 1.0;    // factor of angles and their rates
  double current = 1.0;  // of the input
  double time = 1.0;     // of the time, and of rates its inverse
  bool of_input{true};   // whether of the time of an input that has a file of its own, too
  std::string column{};  // "time_s"; empty: the angle's own name
  std::string looks_like{};
  std::string remedy{};
};

bool counts_frames(const data::Run& run) {
  for (std::size_t i = 1; i < run.times.size(); ++i)
    if (run.times[i] - run.times[i - 1] != 1.0) return false;
  return run.times.size() > 1 && run.times.front() == std::floor(run.times.front());
}

std::vector<Slip> slips_of(const data::Run& run) {
  std::vector<Slip> out;
  out.push_back(
      {.angle = units::degrees_per_radian, .looks_like = "an angle in radians", .remedy = "name the column ..._rad"});
  out.push_back({.angle = -1.0,
                 .looks_like = "an angle that is counted the other way",
                 .remedy = "turn its sign: bending that opens the slits is positive"});
  out.push_back(
      {.current = -1.0,
       .column = "the input",
       .looks_like = "one of the other sign",
       .remedy = "turn its sign: a positive current makes coil and magnet repel, or the leads are exchanged"});
  if (run.drive == simulation::Drive::current)
    out.push_back(
        {.current = 1e-3, .column = "the input", .looks_like = "milliamperes", .remedy = "divide it by 1000"});
  if (counts_frames(run))
    for (const double rate : frame_rates)
      out.push_back({.time = 1.0 / rate,
                     .column = "time_s",
                     .looks_like = fmt::format("frame numbers, at {:.0f} frames a second", rate),
                     .remedy = "divide it by the frame rate"});
  return out;
}

data::Run meant_as(data::Run run, const Slip& slip) {
  for (data::Channel& channel : run.channels) {
    const bool rate = channel.kind == data::ChannelKind::joint_rate;
    if (is_angle(channel) || rate)
      for (double& value : channel.values) value *= slip.angle / (rate ? slip.time : 1.0);
  }
  for (std::vector<double>& row : run.inputs)
    for (double& value : row) value *= slip.current;
  for (double& time : run.times) time *= slip.time;
  if (slip.of_input)
    for (double& time : run.input_times) time *= slip.time;
  if (run.window) *run.window *= slip.time;
  return run;
}

struct Sums {
  double missed = 0.0;    // squares of what the model misses, rad^2
  double varied = 0.0;    // squares of what the records vary about their means
  std::size_t count = 0;  // of readings
};

// Of the first window as `slip` says; nothing where the model cannot follow it.
std::optional<Sums> sums_of(const data::Run& run, const Slip& slip, const replay::DeclaredModel& declared,
                            const fit::Hypothesis& as_declared) {
  const data::Run meant = meant_as(run, slip);
  const auto angles = declared_angles(meant, declared, as_declared);
  if (!angles) return std::nullopt;
  Sums out;
  for (const DeclaredAngle& angle : *angles) {
    const auto size = static_cast<Eigen::Index>(angle.measured.size());
    const Eigen::Map<const Eigen::ArrayXd> seen(angle.measured.data(), size);
    out.missed += (seen - Eigen::Map<const Eigen::ArrayXd>(angle.declared.data(), size)).square().sum();
    out.varied += (seen - seen.mean()).square().sum();
    out.count += angle.measured.size();
  }
  return out;
}

double rms(double squares, std::size_t count) {
  return units::degrees_per_radian * std::sqrt(squares / static_cast<double>(count));
}

std::string column_of(const data::Run& run, const Slip& slip) {
  return slip.column.empty() ? std::ranges::find_if(run.channels, is_angle)->name : slip.column;
}

std::string slip_text(const data::Run& run, const Slip& slip, const Sums& meant, const std::string& as_written) {
  return fmt::format(
      "{}: {}: looks like {}: read so, the declared model misses the angles by {:.2g} deg (rms), as written {}; {}",
      run.name, column_of(run, slip), slip.looks_like, rms(meant.missed, meant.count), as_written, slip.remedy);
}

// The time is another unit's by as much as `slip` says: that of the run, and of its input's own file or not.
std::optional<Sums> followed_as(Slip slip, const data::Run& run, const replay::DeclaredModel& declared,
                                const fit::Hypothesis& as_declared) {
  for (const bool of_input : {true, false}) {
    if (!of_input && run.input_times.empty()) break;
    slip.of_input = of_input;
    const std::optional<Sums> sums = sums_of(run, slip, declared, as_declared);
    if (sums && sums->missed <= follows * follows * sums->varied) return sums;
  }
  return std::nullopt;
}

// By itself, and before anything is simulated as it is written: that would take a thousand times as long.
void require_no_milliseconds(const data::Run& run, const replay::DeclaredModel& declared,
                             const fit::Hypothesis& as_declared) {
  constexpr double slowest_camera = 0.5;  // s
  const double interval = data::usual_interval(run);
  if (interval < slowest_camera) return;
  const Slip slip{.time = 1e-3, .column = "time_s", .looks_like = "milliseconds", .remedy = "name the column time_ms"};
  if (const auto sums = followed_as(slip, run, declared, as_declared))
    throw RecordSlip(slip_text(run, slip, *sums, fmt::format("there is a sample every {:.3g} s", interval)));
}

// Seconds that are called milliseconds: a record of 2 s lasts 2 ms then, in which nothing moves. One that is followed
// as it is written is a fast camera's, or an encoder's.
void require_no_seconds(const data::Run& run, const replay::DeclaredModel& declared,
                        const fit::Hypothesis& as_declared) {
  constexpr double fastest_camera = 5e-4;  // s
  const double interval = data::usual_interval(run);
  if (interval > fastest_camera) return;
  const std::optional<Sums> written = sums_of(run, {}, declared, as_declared);
  if (written && written->missed <= follows * follows * written->varied) return;
  const Slip slip{
      .time = 1e3, .column = "the time column", .looks_like = "seconds", .remedy = "name the column time_s"};
  const auto sums = followed_as(slip, run, declared, as_declared);
  if (sums && (!written || sums->missed <= far_better * far_better * written->missed))
    throw RecordSlip(slip_text(run, slip, *sums, fmt::format("there is a sample every {:.3g} s", interval)));
}

void require_no_slip_of(const data::Run& run, const replay::DeclaredModel& declared,
                        const fit::Hypothesis& as_declared) {
  const std::optional<Sums> written = sums_of(run, {}, declared, as_declared);
  const double missed = written ? written->missed : std::numeric_limits<double>::infinity();
  // What follows the records needs no other reading but of the time.
  const bool follows_as_written = written && missed <= follows * follows * written->varied;
  std::optional<std::pair<Slip, Sums>> best;
  for (Slip& slip : slips_of(run)) {
    const bool of_time = slip.time != 1.0;
    if (follows_as_written && !of_time) continue;
    const std::optional<Sums> sums = sums_of(run, slip, declared, as_declared);
    if (!sums || sums->missed > follows * follows * sums->varied) continue;
    const double ratio = of_time ? better : far_better;
    if (sums->missed > ratio * ratio * missed) continue;
    if (!best || sums->missed / sums->varied < best->second.missed / best->second.varied) best = {slip, *sums};
  }
  if (!best) return;
  const auto& [slip, sums] = *best;
  throw RecordSlip(slip_text(run, slip, sums,
                             written ? fmt::format("by {:.3g} deg", rms(missed, written->count))
                                     : std::string("by more than it can simulate")));
}

}  // namespace

void require_no_slip(std::span<const data::Run> runs, const replay::DeclaredModel& declared) {
  const fit::Hypothesis as_declared(declared, {});
  // Each by itself: of several records one may have come from another program than the others.
  std::size_t looked_at = 0;
  for (const data::Run& run : runs) {
    if (!is_motion_of_angles(run) || looked_at++ >= enough_runs) continue;
    if (run.times.size() > 2) {
      require_no_milliseconds(run, declared, as_declared);
      require_no_seconds(run, declared, as_declared);
    }
    require_no_slip_of(run, declared, as_declared);
  }
}

}  // namespace coilwright::measurement
