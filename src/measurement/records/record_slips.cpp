#include "measurement/records/record_slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/measurement/records/record_slip.hpp"
#include "coilwright/units/angle.hpp"
#include "measurement/data/median_interval.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/records/declared_readings.hpp"
#include "measurement/records/other_readings.hpp"
#include "measurement/records/possible_clock.hpp"
#include "measurement/replay/if_possible.hpp"

namespace coilwright::measurement::records {
namespace {

using data::ChannelKind;
using Of = OtherReading::Of;

// Of the miss as written, and of the variation of the records: far from what any effect changes.
constexpr double far_better = 0.25;
constexpr double half = 0.5;
// Times that count by whole numbers are a sign by themselves, and levels are followed at any rate.
constexpr double better = 0.7;
// Of the distance as written: a factor of 4 (the least of other_readings) is told from one of 3, which no slip made.
constexpr double much_nearer = 0.2;
// What the model itself may be wrong by: a factor of 3, and in rad of its shape.
constexpr double most_distance = 1.6;
constexpr double same_shape = 0.75;
// Slips whose distances differ by less are told apart by what else they say.
constexpr double as_near = 0.02;
// So that a large set costs no more than a second.
constexpr std::size_t enough_motions = 24;

// Nothing where the model cannot follow the input, or where numbers that were meant otherwise are none it can be asked
// for.
using Readings = std::optional<std::vector<DeclaredReadings>>;

// The declared model, asked what a run should show.
struct Declared {
  const replay::DeclaredModel& model;
  fit::Hypothesis as_declared;

  [[nodiscard]] Readings readings_of(const data::Run& run) const {
    return replay::if_possible<Readings::value_type>([&] { return declared_readings(run, model, as_declared); });
  }
};

bool has_natural_zero(ChannelKind kind) {
  return kind == ChannelKind::torque || kind == ChannelKind::force || kind == ChannelKind::joint_rate;
}

// How a record, or one of its channels, compares with the declared model.
struct Comparison {
  ChannelKind kind{};
  MissedSquares squares{};
  RelativeDistance distance{};  // where the kind has a natural zero
  double first{};               // of the first reading from the declared one

  [[nodiscard]] bool follows() const { return squares.missed <= half * half * squares.varied; }
  [[nodiscard]] bool misses_less(const std::optional<Comparison>& than, double ratio) const {
    return !than || squares.missed <= ratio * ratio * than->squares.missed || !std::isfinite(than->squares.missed);
  }
  // Of several slips the one with the least is named.
  [[nodiscard]] double relative() const {
    return has_natural_zero(kind) ? distance.whole() : squares.missed / squares.varied;
  }
};

// Of the channels that `reading` changes; otherwise of all angles of a motion, or of a bench.
std::optional<Comparison> comparison_of(const Readings& readings, const OtherReading& reading) {
  if (!readings) return std::nullopt;
  const bool angles = std::ranges::any_of(*readings, [](const auto& each) { return is_angle(*each.channel); });
  Comparison out;
  for (std::size_t c = 0; c < readings->size(); ++c) {
    const DeclaredReadings& each = (*readings)[c];
    const bool asked = reading.of == Of::channels ? std::ranges::find(reading.channels, c) != reading.channels.end()
                                                  : !angles || is_angle(*each.channel);
    if (!asked) continue;
    out.kind = each.channel->kind;
    add(out.squares, each);
    const RelativeDistance distance = relative_distance(each);
    if (out.distance.whole() < distance.whole()) out.distance = distance;
    out.first = std::abs(each.measured.front() - each.declared.front());
  }
  return out;
}

bool is_slip(const OtherReading& reading, const Comparison& meant, const std::optional<Comparison>& written) {
  if (has_natural_zero(meant.kind))
    return meant.distance.shape <= same_shape && meant.distance.whole() <= most_distance &&
           (!written || meant.distance.whole() <= much_nearer * written->distance.whole());
  if (reading.offset != 0.0)
    return written && meant.first <= far_better * written->first && meant.misses_less(written, half);
  return meant.follows() && meant.misses_less(written, far_better);
}

// Whether no other reading need be looked at: what follows the record as it is written is meant so.
bool is_right(const Comparison& written) {
  return has_natural_zero(written.kind) ? written.distance.whole() < half : written.follows();
}

std::string missed_text(const Comparison& found) {
  const double missed = found.squares.rms();
  switch (found.kind) {
    case ChannelKind::bending_angle:
    case ChannelKind::joint_angle:
      return fmt::format("{:.2g} deg", units::degrees_per_radian * missed);
    case ChannelKind::joint_rate:
      return fmt::format("{:.2g} rad/s", missed);
    case ChannelKind::torque:
      return fmt::format("{:.2g} N mm", 1e3 * missed);
    case ChannelKind::force:
      return fmt::format("{:.2g} N", missed);
    case ChannelKind::temperature:
      break;
  }
  return fmt::format("{:.2g} K", missed);
}

std::string what_is_missed(const Comparison& found) {
  switch (found.kind) {
    case ChannelKind::bending_angle:
    case ChannelKind::joint_angle:
      return "the angles";
    case ChannelKind::joint_rate:
      return "the rate";
    case ChannelKind::torque:
      return "the torque";
    case ChannelKind::force:
      return "the force";
    case ChannelKind::temperature:
      break;
  }
  return "the temperature";
}

RecordSlip slip(const data::Run& run, const OtherReading& reading, const Comparison& meant,
                const std::string& as_written) {
  return RecordSlip(
      fmt::format("{}: {}: looks like {}: read so, the declared model misses {} by {} (rms), as written "
                  "{}; {}",
                  run.name, reading.column, reading.looks_like, what_is_missed(meant), missed_text(meant), as_written,
                  reading.remedy));
}

std::string missed_as_written(const std::optional<Comparison>& written) {
  return written && std::isfinite(written->squares.missed) ? fmt::format("by {}", missed_text(*written))
                                                           : std::string("by more than it can simulate");
}

// A slip that may be named, and what it is held against; nothing where that cannot be simulated.
struct Found {
  OtherReading reading;
  Comparison meant;
  std::optional<Comparison> written{};
  double unusual{};
};

// The clocks of motions. One that is slower than any camera's is not simulated as it is written, which would take a
// thousand times as long, but where it counts. Seconds that are called milliseconds are a record of 2 s that lasts 2
// ms, in which nothing moves; one that is followed as it is written is a fast camera's, or an encoder's. Of several
// units that a camera may have, such as hours and days, the model tells by which it misses least. Returns what the
// model declares as it is written.
Readings readings_on_its_clock(const data::Run& run, const Declared& declared) {
  if (run.times.size() < 3) return declared.readings_of(run);
  const double interval = data::median_interval(run);
  const bool counts = counts_by_ones(run);
  const bool slow = interval >= slowest_camera && !counts;
  Readings as_written = slow ? std::nullopt : declared.readings_of(run);
  const auto written = comparison_of(as_written, {.of = Of::time});
  const bool follows = written && written->follows();
  std::optional<Found> best;
  for (const OtherReading& reading : other_readings(run)) {
    if (reading.of != Of::time || !is_of_a_camera(reading.factor * interval) || (follows && !reading.counts)) continue;
    const data::Run run_meant = read_as(run, reading);
    const auto meant = comparison_of(declared.readings_of(run_meant), reading);
    if (!meant || !meant->follows() || !meant->misses_less(written, reading.counts ? better : far_better)) continue;
    if (!best || meant->relative() < best->meant.relative()) best = {reading, *meant, written};
  }
  if (best)
    throw slip(run, best->reading, best->meant,
               counts ? missed_as_written(written) : fmt::format("there is a sample every {:.3g} s", interval));
  if (!follows) require_possible_clock(run);
  return slow ? declared.readings_of(run) : as_written;
}

// The comparison of `run` as it may have been meant. What the model declares does not follow from the channels.
std::optional<Comparison> meant_as(const OtherReading& reading, const data::Run& run, Readings as_written,
                                   const Declared& declared) {
  if (reading.of != Of::channels) {
    const data::Run meant = read_as(run, reading);
    return comparison_of(declared.readings_of(meant), reading);
  }
  if (!as_written) return std::nullopt;
  for (const std::size_t c : reading.channels)
    for (double& value : (*as_written)[c].measured) value = reading.factor * value + reading.offset;
  return comparison_of(as_written, reading);
}

// How far the largest current is from an ampere as it is meant then, by its logarithm. Torques and forces are
// proportional to the current: N m for N mm and mA for A look alike, and one of them leaves a current that no coil has.
double unusual_current(const data::Run& run, const OtherReading& reading) {
  double largest = 0.0;
  for (const std::vector<double>& row : run.inputs)
    for (const double value : row) largest = std::max(largest, std::abs(value));
  if (largest == 0.0 || run.drive != data::Drive::current) return 0.0;
  return std::abs(std::log(largest * (reading.of == Of::input ? std::abs(reading.factor) : 1.0)));
}

void require_no_slip_of(const data::Run& run, const Declared& declared) {
  const bool motion = run.kind == data::RunKind::transient;
  const Readings as_written = motion ? readings_on_its_clock(run, declared) : declared.readings_of(run);
  std::optional<Found> best;
  for (const OtherReading& reading : other_readings(run)) {
    if (motion && reading.of == Of::time) continue;
    const std::optional<Comparison> written = comparison_of(as_written, reading);
    if (written && is_right(*written)) continue;
    const auto meant = meant_as(reading, run, as_written, declared);
    if (!meant || !is_slip(reading, *meant, written)) continue;
    const double unusual = unusual_current(run, reading);
    const double ahead = best ? best->meant.relative() - meant->relative() : 1.0;
    if (std::abs(ahead) <= as_near ? unusual < best->unusual : ahead > 0.0) best = {reading, *meant, written, unusual};
  }
  if (!best) return;
  throw slip(run, best->reading, best->meant, missed_as_written(best->written));
}

}  // namespace

void require_no_slip(std::span<const data::Run> runs, const replay::DeclaredModel& model) {
  const Declared declared{.model = model, .as_declared = fit::Hypothesis(model, {})};
  // Each by itself: of several records one may have come from another program than the others.
  std::size_t motions = 0;
  for (const data::Run& run : runs) {
    if (run.kind == data::RunKind::still) continue;
    if (run.kind == data::RunKind::transient && (!is_motion_of_angles(run) || motions++ >= enough_motions)) {
      require_possible_clock(run);
      continue;
    }
    require_no_slip_of(run, declared);
  }
}

}  // namespace coilwright::measurement::records
