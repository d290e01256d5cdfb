#include "truth/laboratory/recorder.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "degree.hpp"
#include "truth/laboratory/noise.hpp"
#include "truth/laboratory/run_keys.hpp"

namespace truth::laboratory {
namespace {

// Gauss's rule of three points for the mean over an exposure of length 1 about 0: exact for polynomials of degree 5.
struct Part {
  double at;
  double weight;
};
constexpr std::array<Part, 3> parts{
    {{-0.3872983346207417, 5.0 / 18.0}, {0.0, 8.0 / 18.0}, {0.3872983346207417, 5.0 / 18.0}}};

}  // namespace

double current_at(const Experiment& experiment, double time) {
  const auto after = std::upper_bound(experiment.times.begin(), experiment.times.end(), time + 1e-9);
  const auto index = std::max<std::ptrdiff_t>(after - experiment.times.begin() - 1, 0);
  return experiment.currents[static_cast<std::size_t>(index)];
}

std::vector<double> input_changes(const PlannedRun& run) {
  std::vector<double> out;
  for (const double time : run.experiment.times) {
    if (time < run.begins) continue;
    if (!out.empty() && time - run.begins < out.back() + 1e-6) out.pop_back();
    out.push_back(time - run.begins);
  }
  return out;
}

std::vector<double> picture_times(const Request& request, const PlannedRun& run) {
  std::vector<double> out;
  const double interval = 1.0 / request.camera.frame_rate;
  for (int i = 0; i * interval < run.duration - 1e-9; ++i) out.push_back(i * interval);
  return out;
}

std::vector<double> input_times_of(const Request& request, const PlannedRun& run) {
  std::vector<double> out;
  switch (request.clocks.log) {
    case InputLog::beside_pictures:
      return picture_times(request, run);
    case InputLog::every_change:
      return input_changes(run);
    case InputLog::own_samples:
      for (int i = 0; i / request.clocks.own_rate < run.duration; ++i) out.push_back(i / request.clocks.own_rate);
      break;
  }
  return out;
}

Recorder::Recorder(const Request& request, Random& random) : request_(request), random_(random) {
  rate_ = random_.sign() * request.clocks.rate;
}

Recorder::Session Recorder::open_session(const PlannedRun& planned) {
  const ClockFaults& clocks = request_.clocks;
  Session session{.clock = {.offset = random_.sign() * random_.uniform(clocks.smallest_offset, clocks.largest_offset),
                            .rate = rate_},
                  .stamps = {},
                  .middles = {}};
  // To the last digit of the file.
  const double late =
      clocks.latest_start > 0.0 ? 1e-6 * std::round(1e6 * random_.uniform(0.0, clocks.latest_start)) : 0.0;
  double before = 0.0;
  for (const double picture : picture_times(request_, planned)) {
    const double stamp = late + picture;
    if (stamp >= planned.duration) break;
    const double is = stamp + request_.camera.jitter * random_.normal();
    before = std::max(before, planned.begins + (1.0 + session.clock.rate) * is + session.clock.offset);
    session.stamps.push_back(stamp);
    session.middles.push_back(before);
  }
  return session;
}

RecordedRun Recorder::record(const PlannedRun& planned, const Session& session, const Finger& finger,
                             const UnmodelledEffects& effects) {
  RecordedRun run;
  run.planned = planned;
  run.clock = session.clock;
  run.stamps = session.stamps;
  Experiment filmed = planned.experiment;
  const double exposure = request_.camera.exposure_share / request_.camera.frame_rate;
  const std::size_t each = exposure > 0.0 ? parts.size() : 1;
  for (const double middle : session.middles)
    for (std::size_t p = 0; p < each; ++p)
      filmed.seen.push_back(std::max(middle + (each > 1 ? parts[p].at * exposure : 0.0), 0.0));
  std::sort(filmed.seen.begin(), filmed.seen.end());  // pictures at the start, which the clock puts before the run
  const Eigen::VectorXd seen = camera_view(request_.channels, effects, filmed, simulate(finger, effects, filmed));
  const int channels = channel_count(request_.channels);
  for (std::size_t i = 0; i < session.middles.size(); ++i) {
    std::vector<double>& row = run.angles_deg.emplace_back(channels, 0.0);
    for (std::size_t p = 0; p < each; ++p)
      for (int c = 0; c < channels; ++c)
        row[c] += (each > 1 ? parts[p].weight : 1.0) * seen[static_cast<Eigen::Index>((i * each + p) * channels + c)] /
                  degree;
  }
  add_noise(run.angles_deg, session.middles);
  add_outliers(run);
  log_input(run);
  return run;
}

RecordedRun Recorder::record_still(const Finger& finger, const UnmodelledEffects& effects, double duration) {
  PlannedRun planned{.experiment = {}, .begins = 0.0, .duration = duration, .wave = {}, .validate = false};
  planned.experiment.name = "still";
  planned.experiment.times = {0.0};
  planned.experiment.currents = {0.0};
  const Session session = open_session(planned);
  RecordedRun run;
  run.planned = planned;
  run.clock = session.clock;
  run.stamps = session.stamps;
  const auto angles = equilibrium(finger, effects, 0.0);
  const Eigen::VectorXd seen = camera_view(request_.channels, effects, planned.experiment, {angles});
  std::vector<double> row;
  for (const double angle : seen) row.push_back(angle / degree);
  run.angles_deg.assign(session.stamps.size(), row);
  add_noise(run.angles_deg, session.middles);
  return run;
}

void Recorder::add_noise(std::vector<std::vector<double>>& angles, const std::vector<double>& times) {
  const double level = request_.noise.level / degree;
  for (int c = 0; c < channel_count(request_.channels); ++c) {
    const std::vector<double> noise = Noise(request_.noise.colour, random_).at(times);
    for (std::size_t i = 0; i < angles.size(); ++i)
      angles[i][c] = std::round((angles[i][c] + level * noise[i]) / resolution_deg) * resolution_deg;
  }
}

void Recorder::add_outliers(RecordedRun& run) {
  if (request_.noise.outliers <= 0.0) return;
  for (std::size_t i = 0; i < run.angles_deg.size(); ++i) {
    if (random_.uniform() >= request_.noise.outliers) continue;
    const double by = random_.sign() * std::round(random_.uniform(3.0, 10.0) / resolution_deg) * resolution_deg;
    for (double& angle : run.angles_deg[i]) angle += by;
    run.outliers.push_back({.time = run.stamps[i], .by = by * degree});
  }
}

void Recorder::log_input(RecordedRun& run) {
  const Experiment& experiment = run.planned.experiment;
  run.input_times = input_times_of(request_, run.planned);
  const bool between = hold_of(request_, run.planned) == "linear";
  for (const double time : run.input_times)
    run.currents.push_back((between ? run.planned.wave(time) : current_at(experiment, run.planned.begins + time)) +
                           (request_.noise.input_noise > 0.0 ? request_.noise.input_noise * random_.normal() : 0.0));
}

}  // namespace truth::laboratory
