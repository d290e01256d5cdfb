#pragma once

#include <functional>
#include <vector>

#include "truth/laboratory/request.hpp"
#include "truth/motion.hpp"
#include "truth/random.hpp"

namespace truth::laboratory {

/// A run as it is driven.
struct PlannedRun {
  Experiment experiment;  ///< every change of the current, at the driver's 500 updates per second and at edges
  double begins{};        ///< s: the record begins so long after the run, when the finger moves already
  double duration{};      ///< s, of the record
  std::function<double(double)> wave{};  ///< A over the time of the run, s; nothing for an input with edges
  bool validate = false;
};

/// The same run driven by a generator that goes straight from one of these samples of its wave to the next.
[[nodiscard]] PlannedRun drawn_through(PlannedRun run, const std::vector<double>& samples);

/// Where the edges of an input lie: on the driver's updates, or anywhere.
enum class Edges { on_updates, anywhere };

/// paper: the runs of paper_runs(). few: three steps and a release. one: one step down. sines: four sines. rig_changes:
/// steps, and releases with the base turned by 30 degrees to either side, with 5 g at the tip, and, recorded from 30 ms
/// after the current has gone, with the coils open and, if `shorted`, shorted. hold: steps, and 20 s at 1.3 A between
/// steps of a cold and a warm finger. All but `one` have runs to validate.
[[nodiscard]] std::vector<PlannedRun> plan_runs(Programme programme, Edges edges, bool shorted, Random& random);

}  // namespace truth::laboratory
