#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "truth/camera.hpp"
#include "truth/experiments.hpp"
#include "truth/hidden_effect.hpp"

namespace truth {

/// Which runs are recorded: paper_runs() or brief_runs().
enum class Programme { paper, brief };

/// What a set is to contain.
struct DataSetRequest {
  std::vector<std::string> hidden{};  ///< ids of hidden kinds; empty if the declared model is complete
  std::uint64_t seed = 1;
  Camera camera = Camera::bending_angle;
  Programme programme = Programme::paper;
  double weakest = 3.0;              ///< smallest strength, in standard deviations of the noise
  double strongest = 15.0;           ///< largest strength
  bool states_exact_numbers = true;  ///< whether the set says that the declared numbers are exact
  bool find_confounders = false;     ///< whether to search confounders of a single hidden effect, which takes seconds
};

/// What the diagnosis is not told.
struct Answer {
  std::uint64_t seed{};
  std::vector<HiddenEffect> hidden{};
  double joint_stiffness{};  ///< true, N m/rad
  double joint_damping{};    ///< true, N m s/rad
  double noise{};            ///< standard deviation of an angle, rad
  double resolution{};       ///< angles are rounded to its multiples, rad
};

/// A recorded run: the command, and the readings of the camera, deg, one row per sample.
struct RecordedRun {
  Experiment experiment;
  bool validate = false;
  std::vector<std::vector<double>> angles_deg;
};

struct DataSet {
  DataSetRequest request;
  Answer answer;
  std::vector<RecordedRun> runs;
};

/// Simulates the runs with the hidden effects. The same request gives the same set.
[[nodiscard]] DataSet make_data_set(const DataSetRequest& request);

/// Writes dataset.json, finger.json (the declared lumped-model/1: Table II) and one CSV file per run.
void write_data_set(const DataSet& set, const std::filesystem::path& folder);

/// Writes the answer as JSON; it belongs outside the folder of the set.
void write_answer(const Answer& answer, const std::filesystem::path& file);

}  // namespace truth
