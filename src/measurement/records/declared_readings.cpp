#include "measurement/records/declared_readings.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "coilwright/simulation/initial_state.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/replay/prepared_run.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::records {
namespace {

// Of the samples in `range`, channel after channel; nothing where the model has no answer.
std::optional<Eigen::VectorXd> declared_values(const replay::PreparedRun& prepared, const actuator::Model& model,
                                               const replay::DeclaredModel& declared) {
  if (!prepared.is_motion()) return replay::predict_bench(model, prepared, declared);
  const replay::Window& window = prepared.windows.front();
  const auto rest = simulation::equilibrium_at_first_input(model, window.input);
  if (!rest) return std::nullopt;
  auto predicted = replay::predict_window(model, prepared, window, *rest);
  return predicted ? std::optional(std::move(predicted->values)) : std::nullopt;
}

using Values = Eigen::VectorXd;

Values values_of(const std::vector<double>& values) {
  return Eigen::Map<const Values>(values.data(), static_cast<Eigen::Index>(values.size()));
}

double angle_between(const Values& a, const Values& b) {
  const double norms = a.norm() * b.norm();
  return norms > 0.0 ? std::acos(std::clamp(a.dot(b) / norms, -1.0, 1.0)) : 0.5 * M_PI;
}

}  // namespace

bool is_angle(const data::Channel& channel) {
  return channel.kind == data::ChannelKind::bending_angle || channel.kind == data::ChannelKind::joint_angle;
}

bool is_motion_of_angles(const data::Run& run) {
  return run.kind == data::RunKind::transient && run.start == data::Start::at_rest &&
         std::ranges::any_of(run.channels, is_angle);
}

std::optional<std::vector<DeclaredReadings>> declared_readings(const data::Run& run,
                                                               const replay::DeclaredModel& declared,
                                                               const fit::Hypothesis& as_declared) {
  const actuator::ModelSpec spec = as_declared.spec_at(as_declared.start());
  const replay::PreparedRun prepared = replay::prepare_run(run, declared, actuator::Model(spec));
  const actuator::Model model(replay::on_changed_rig(spec, run.rig));
  const auto values = declared_values(prepared, model, declared);
  if (!values) return std::nullopt;
  const replay::SampleRange range = prepared.sample_ranges().front();
  const auto samples = static_cast<Eigen::Index>(range.samples());
  std::vector<DeclaredReadings> out;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const std::vector<double>& measured = run.channels[c].values;
    const auto of_channel = values->segment(static_cast<Eigen::Index>(c) * samples, samples);
    out.push_back({.channel = &run.channels[c],
                   .measured = {measured.begin() + static_cast<std::ptrdiff_t>(range.first),
                                measured.begin() + static_cast<std::ptrdiff_t>(range.last)},
                   .declared = {of_channel.begin(), of_channel.end()}});
  }
  return out;
}

double MissedSquares::rms() const {
  return std::sqrt(missed / static_cast<double>(count));
}

void add(MissedSquares& sums, const DeclaredReadings& readings) {
  const Values measured = values_of(readings.measured);
  sums.missed += (measured - values_of(readings.declared)).squaredNorm();
  sums.varied += (measured.array() - measured.mean()).matrix().squaredNorm();
  sums.count += readings.measured.size();
}

double RelativeDistance::whole() const {
  return std::hypot(size, shape);
}

RelativeDistance relative_distance(const DeclaredReadings& readings) {
  constexpr double varies = 0.1;         // of the size
  constexpr double least_varied = 0.01;  // of what is declared: it may vary by less, and no ratio is made of that
  const Values measured = values_of(readings.measured);
  const Values declared = values_of(readings.declared);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!measured.allFinite() || !declared.allFinite() || measured.norm() == 0.0 || declared.norm() == 0.0)
    return {.size = infinity, .shape = infinity};
  RelativeDistance out{.size = std::log(measured.norm() / declared.norm()), .shape = angle_between(measured, declared)};
  const Values about = measured.array() - measured.mean();
  const Values declared_about = declared.array() - declared.mean();
  if (about.norm() < varies * measured.norm() && declared_about.norm() < varies * declared.norm()) return out;
  const double size = std::log(about.norm() / std::max(declared_about.norm(), least_varied * declared.norm()));
  return {.size = std::hypot(out.size, size), .shape = std::hypot(out.shape, angle_between(about, declared_about))};
}

}  // namespace coilwright::measurement::records
