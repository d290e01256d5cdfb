#pragma once

#include <vector>

#include "truth/laboratory/recorded_run.hpp"
#include "truth/laboratory/request.hpp"
#include "truth/recording.hpp"

namespace truth::laboratory {

/// The stamps of the pictures of a run, and the times at which its input is logged, s, each on its own clock.
[[nodiscard]] std::vector<double> picture_times(const Request& request, const PlannedRun& run);
[[nodiscard]] std::vector<double> input_times_of(const Request& request, const PlannedRun& run);

/// The times at which a run's input changes, s from its beginning. Changes nearer than a file's last digit are one: the
/// later, whose current is what holds.
[[nodiscard]] std::vector<double> input_changes(const PlannedRun& run);

/// The current that the driver holds at a time of the experiment, A.
[[nodiscard]] double current_at(const Experiment& experiment, double time);

/// The bench: films fingers and writes down what it sees.
class Recorder {
 public:
  Recorder(const Request& request, Random& random);

  /// When the shutter is open in the middle of each picture, in the time of the input; draws the run's clock.
  struct Session {
    RunClock clock;
    std::vector<double> stamps;
    std::vector<double> middles;
  };
  [[nodiscard]] Session open_session(const PlannedRun& planned);

  [[nodiscard]] RecordedRun record(const PlannedRun& planned, const Session& session, const Finger& finger,
                                   const UnmodelledEffects& effects);

  /// A finger at rest without current, for so many seconds.
  [[nodiscard]] RecordedRun record_still(const Finger& finger, const UnmodelledEffects& effects, double duration);

 private:
  void add_noise(std::vector<std::vector<double>>& angles, const std::vector<double>& times);
  void add_outliers(RecordedRun& run);
  void log_input(RecordedRun& run);

  const Request& request_;
  Random& random_;
  double rate_ = 0.0;  // of the clocks
};

}  // namespace truth::laboratory
