#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "truth/laboratory/built_finger.hpp"
#include "truth/laboratory/recorded_run.hpp"
#include "truth/laboratory/request.hpp"
#include "truth/recording.hpp"

namespace truth::laboratory {

/// What a fit can do to an effect without naming it: stiffness and damping are free, declared numbers move within their
/// tolerances (unless the set calls them exact), the clock of each run, and an edge between two samples, within theirs.
class Absorption {
 public:
  /// The fit runs as they were filmed, and what the finger shows in them without the effect. Must outlive the
  /// absorption.
  struct Place {
    const Request& request;
    const BuiltFinger& built;
    const UnmodelledEffects& others;         ///< that are hidden beside it
    const std::vector<PlannedRun>& planned;  ///< of the fit runs
    const std::vector<Experiment>& fit;
    RecordedAngles without;
    double noise{};  ///< rad
  };
  explicit Absorption(const Place& place);

  /// Standard deviations of the noise, over all samples, by which `moved` differs from the finger without the effect
  /// at least, what was moved counted in standard deviations of its prior. Where the search for the least fails, it is
  /// too large, never too small.
  [[nodiscard]] double left_of(const RecordedAngles& moved) const;

 private:
  // A finger and how late each run is seen.
  struct Bench {
    Finger finger;
    std::vector<RunClock> clocks;
  };
  // A number that may move, in standard deviations of its prior; a free one in parts of its value.
  struct Unknown {
    std::function<void(Bench&, double)> move;
    double step;   // of its slope
    double prior;  // 1, or 0 for a free one
  };

  void add_numbers();
  void add_clocks();
  [[nodiscard]] RecordedAngles seen_with(const Eigen::VectorXd& moves) const;
  [[nodiscard]] Eigen::MatrixXd slopes_at(const Eigen::VectorXd& moves) const;
  [[nodiscard]] Eigen::VectorXd left_after(const Eigen::VectorXd& moves, const RecordedAngles& moved) const;
  // What runs differ by, over the noise: as long as all samples together.
  [[nodiscard]] Eigen::VectorXd difference(const RecordedAngles& from, const RecordedAngles& to) const;

  Place place_;
  std::vector<Unknown> unknowns_;
};

}  // namespace truth::laboratory
