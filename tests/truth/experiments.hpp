#pragma once

#include <vector>

#include "truth/motion.hpp"

namespace truth {

/// What was done on the bench, 500 samples a second.
struct Bench {
  std::vector<Experiment> fit;       ///< the paper's steps and sines (23), a release from 1.4 A, a hold of 15 s
  std::vector<Experiment> validate;  ///< other amplitudes and frequencies, and a train of pulses
};

/// Currents have six decimals, as the files do.
[[nodiscard]] Bench paper_bench();

/// What a hurried person does: a quarter of the samples, the hold but 2 s long, two validate runs.
[[nodiscard]] Bench brief_bench();

}  // namespace truth
