#include "measurement/replay/local_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::measurement::replay {
namespace {

// The hum of a run may be a few times that of the record in which nothing moved.
constexpr double line_freedom = 3.0;

// What the noise of an input does to a motion cannot be told from what a model lacks that is wrong by so many times the
// noise: fitted, its errors would take that up. Each costs a simulation for its derivative, too.
constexpr double hides_input_noise = 10.0;

// An input that changes between its samples was read at a time that nobody knows better than to a tenth of their
// interval: a driver that holds its own samples is late by half of their interval.
double unknown_reading_time(const data::Run& run) {
  constexpr double share = 0.1;
  if (run.hold == data::InputHold::zero_order) return 0.0;
  const std::vector<double>& times = run.times_of_inputs();
  return share * (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

bool is_angle(const data::Channel& channel) {
  return channel.kind == data::ChannelKind::bending_angle || channel.kind == data::ChannelKind::joint_angle;
}

}  // namespace

LocalNumbers::LocalNumbers(const PreparedRun& prepared, const Window& window)
    : joints_(static_cast<int>(window.prior.mean.angles.size())), has_state_(prepared.fits_initial_state(window)) {
  if (has_state_) {
    for (int j = 0; j < joints_; ++j) add(window.prior.mean.angles[j], window.prior.sigma.angles[j]);
    for (int j = 0; j < joints_; ++j) add(window.prior.mean.rates[j], window.prior.sigma.rates[j]);
  }
  first_edge_ = size();
  edges_ = window.edges.size();
  for (std::size_t i = 0; i < edges_; ++i) add(0.0, 1.0);
  has_bend_ = !window.bend.times.empty();
  if (has_bend_) {
    // A logger that says `linear` knows as little of what is between its samples as another one.
    const bool straight = prepared.run->hold == data::InputHold::linear;
    add(straight ? 0.5 : 1.0, straight ? 0.5 : 0.3);
  }
  first_error_ = size();
  errors_ = prepared.model_error < hides_input_noise ? window.errors.size() : 0;
  for (std::size_t i = 0; i < errors_; ++i) add(0.0, 1.0);
  clock_ = size();
  const data::RecordingClock& clock = prepared.run->clock;
  const double offset_sigma = std::max(clock.offset_sigma, unknown_reading_time(*prepared.run));
  has_offset_ = offset_sigma > 0.0;
  has_rate_ = clock.rate_sigma > 0.0;
  if (has_offset_) add(0.0, offset_sigma);
  if (has_rate_) add(0.0, clock.rate_sigma);
  first_amplitude_ = size();
  for (const data::Channel& channel : prepared.run->channels)
    for (const double amplitude : prepared.line_sizes)
      for (int i = 0; i < 4 && is_angle(channel); ++i) add(0.0, line_freedom * amplitude);
}

void LocalNumbers::add(double mean, double sigma) {
  mean_.push_back(mean);
  sigma_.push_back(sigma);
}

simulation::State LocalNumbers::initial_state(std::span<const double> values,
                                              const actuator::InternalStates& internal) const {
  return {.angles = Eigen::Map<const Eigen::VectorXd>(values.data(), joints_),
          .rates = Eigen::Map<const Eigen::VectorXd>(values.data() + joints_, joints_),
          .internal = internal};
}

std::span<const double> LocalNumbers::edge_numbers(std::span<const double> values) const {
  return values.subspan(first_edge_, edges_);
}

std::optional<std::size_t> LocalNumbers::edge_of(std::size_t i) const {
  if (i < first_edge_ || i >= first_edge_ + edges_) return std::nullopt;
  return i - first_edge_;
}

double LocalNumbers::bend(std::span<const double> values) const {
  return has_bend_ ? values[first_edge_ + edges_] : 0.0;
}

std::span<const double> LocalNumbers::input_errors(std::span<const double> values) const {
  return values.subspan(first_error_, errors_);
}

double LocalNumbers::clock_offset(std::span<const double> values) const {
  return has_offset_ ? values[clock_] : 0.0;
}

double LocalNumbers::clock_rate(std::span<const double> values) const {
  const auto number = clock_rate_number();
  return number ? values[*number] : 0.0;
}

std::optional<std::size_t> LocalNumbers::clock_rate_number() const {
  if (!has_rate_) return std::nullopt;
  return clock_ + (has_offset_ ? 1 : 0);
}

std::span<const double> LocalNumbers::line_amplitudes(std::span<const double> values) const {
  return values.subspan(first_amplitude_);
}

}  // namespace coilwright::measurement::replay
