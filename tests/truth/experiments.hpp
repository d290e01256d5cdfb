#pragma once

#include <vector>

#include "truth/motion.hpp"

namespace truth {

/// The runs of a session, 500 samples per second.
struct PlannedRuns {
  std::vector<Experiment> fit;       ///< the paper's steps and sines (23), a release from 1.4 A, a hold of 15 s
  std::vector<Experiment> validate;  ///< other amplitudes and frequencies, and a train of pulses
};

/// Currents have six decimals, as in the files.
[[nodiscard]] PlannedRuns paper_runs();

/// A short session: a quarter of the samples, a hold of 2 s, two validate runs.
[[nodiscard]] PlannedRuns brief_runs();

}  // namespace truth
