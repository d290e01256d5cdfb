#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "truth/camera.hpp"
#include "truth/experiments.hpp"

namespace truth {

/// What is done with the finger: paper_bench(), or brief_bench().
enum class Programme { paper, brief };

/// What a set is to hold.
struct Order {
  std::vector<std::string> hidden{};  ///< ids of hidden kinds; empty: the declared model is right
  std::uint64_t seed = 1;
  Camera camera = Camera::bending_angle;
  Programme programme = Programme::paper;
  double weakest = 3.0;  ///< strength, in standard deviations of the noise
  double strongest = 15.0;
  bool find_rivals = false;  ///< of a single hidden effect; takes seconds
};

/// One thing that is hidden, with its numbers.
struct HiddenEffect {
  struct Number {
    std::string key;
    double value{};  ///< in the key's unit
  };
  std::string id;
  bool outsider = false;
  std::vector<Number> numbers;
  double asked{};     ///< strength that was drawn; 0 for what is there or not
  double strength{};  ///< rms deviation from the motion without it over the noise, in the fit run where it is largest
  /// The same after the declared stiffness and damping have taken up what they can (to first order).
  double strength_after_calibration{};
  /// Whether that can be seen at all: six standard deviations over all samples of the fit runs together.
  bool visible = false;
  std::vector<std::string> rivals{};  ///< ids that could pass for it in these data; empty unless asked for
};

/// What nobody tells the diagnosis.
struct Answer {
  std::uint64_t seed{};
  std::vector<HiddenEffect> hidden{};
  double joint_stiffness{};  ///< true, N m/rad
  double joint_damping{};    ///< true, N m s/rad
  double noise{};            ///< of an angle, standard deviation, rad
  double resolution{};       ///< angles are rounded to it, rad
};

/// A recorded run: the command, and what the camera wrote, degrees, one row a sample.
struct Recording {
  Experiment experiment;
  bool validate = false;
  std::vector<std::vector<double>> angles_deg;
};

struct DataSet {
  Order order;
  Answer answer;
  std::vector<Recording> runs;
};

/// Bends the finger through the paper's experiments with the effects hidden in it. The same order, the same set.
[[nodiscard]] DataSet make_data_set(const Order& order);

/// Writes dataset.json, finger.json (the declared lumped-model/1: Table II) and a CSV a run.
void write_data_set(const DataSet& set, const std::filesystem::path& folder);

/// The answer as JSON; keep it away from the set.
void write_answer(const Answer& answer, const std::filesystem::path& file);

}  // namespace truth
