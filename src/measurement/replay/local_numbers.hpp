#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// What only one window of one run tells, and every fit therefore eliminates: its initial state, the shift and the rate
/// of its clocks, where the edges of its input lie, what noise has left in it, and the hum in its readings.
class LocalNumbers {
 public:
  LocalNumbers() = default;
  LocalNumbers(const PreparedRun& prepared, const Window& window);

  /// Number of them; 0 for a window that starts at rest, with one clock and no hum.
  [[nodiscard]] std::size_t size() const { return mean_.size(); }
  /// Their prior: independent normal distributions.
  [[nodiscard]] const std::vector<double>& mean() const { return mean_; }
  [[nodiscard]] const std::vector<double>& sigma() const { return sigma_; }

  [[nodiscard]] bool has_initial_state() const { return has_state_; }
  /// Whether number `i` is an angle or a rate of the initial state.
  [[nodiscard]] bool is_state(std::size_t i) const { return i < first_edge_; }
  /// Whether number `i` changes the motion; otherwise it changes only what is shown of it.
  [[nodiscard]] bool moves(std::size_t i) const { return i < clock_; }

  /// Throws nothing; `values` are as many as size().
  [[nodiscard]] simulation::State initial_state(std::span<const double> values,
                                                const actuator::InternalStates& internal) const;
  /// How much of the window's `bend` the input has: 0 is straight between samples, 1 smooth.
  [[nodiscard]] double bend(std::span<const double> values) const;
  /// The errors of the window's input, each over its standard deviation; none where a model error hides them.
  [[nodiscard]] std::span<const double> input_errors(std::span<const double> values) const;
  /// Where each edge of the window's input lies: numbers of InputEdge::shift().
  [[nodiscard]] std::span<const double> edge_numbers(std::span<const double> values) const;
  /// Which edge of the window number `i` places, if it is one of those.
  [[nodiscard]] std::optional<std::size_t> edge_of(std::size_t i) const;
  [[nodiscard]] double clock_offset(std::span<const double> values) const;  ///< s
  [[nodiscard]] double clock_rate(std::span<const double> values) const;
  /// Which of the numbers is the rate of the clock, if any.
  [[nodiscard]] std::optional<std::size_t> clock_rate_number() const;
  /// Four amplitudes a line and angle channel: cosine, sine, and both growing over the window; rad.
  [[nodiscard]] std::span<const double> line_amplitudes(std::span<const double> values) const;

 private:
  void add(double mean, double sigma);

  int joints_{};
  bool has_state_{}, has_bend_{}, has_offset_{}, has_rate_{};
  std::size_t edges_{}, first_edge_{}, errors_{}, first_error_{}, clock_{}, first_amplitude_{};
  std::vector<double> mean_, sigma_;
};

}  // namespace coilwright::measurement::replay
