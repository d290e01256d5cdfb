// Writes a set as a laboratory would make it, with faults and hidden effects, and the answer into a file elsewhere.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <string>

#include "run_program.hpp"
#include "truth/laboratory/laboratory_set.hpp"
#include "truth/laboratory/names.hpp"

namespace {

using namespace truth::laboratory;

template <typename Choice>
std::map<std::string, Choice> words(int count) {
  std::map<std::string, Choice> out;
  for (int i = 0; i < count; ++i) out[std::string(name_of(static_cast<Choice>(i)))] = static_cast<Choice>(i);
  return out;
}

int run(int argc, char** argv) {
  CLI::App app("Writes a measured-data/1 set as a laboratory would make it", "laboratory_set");
  Request request;
  std::string folder;
  std::string answer;
  app.add_option("--hide", request.hidden, "Effects that the declared model lacks (truth_set --list)");
  app.add_option("--values", request.values, "Value of the first number of each hidden effect");
  app.add_option("--seed", request.seed, "Random seed")->capture_default_str();
  app.add_option("--programme", request.programme, "Runs")
      ->transform(CLI::CheckedTransformer(words<Programme>(6), CLI::ignore_case));
  app.add_option("--numbers", request.deviation, "How far the declared numbers are off")
      ->transform(CLI::CheckedTransformer(words<Deviation>(3)));
  app.add_option("--tolerances", request.tolerances, "What the set says of tolerances")
      ->transform(CLI::CheckedTransformer(words<Tolerances>(3)));
  app.add_option("--faces", request.faces, "Declared faces: none, or absent or elsewhere on the finger")
      ->transform(CLI::CheckedTransformer(words<DeclaredFaces>(3)));
  app.add_option("--frame-rate", request.camera.frame_rate, "Pictures per second")->capture_default_str();
  app.add_option("--exposure", request.camera.exposure_share, "Exposure over the time between pictures");
  app.add_option("--jitter-s", request.camera.jitter, "Jitter of the pictures");
  app.add_option("--input", request.clocks.log, "Where the input is logged")
      ->transform(CLI::CheckedTransformer(words<InputLog>(3)));
  app.add_option("--smallest-offset-s", request.clocks.smallest_offset, "Smallest offset of the clocks");
  app.add_option("--largest-offset-s", request.clocks.largest_offset, "Largest offset of the clocks");
  app.add_option("--clock-rate", request.clocks.rate, "Relative difference of the clocks' rates");
  app.add_option("--latest-start-s", request.clocks.latest_start,
                 "How long after the input the pictures begin, at most");
  app.add_option("--noise", request.noise.colour, "Colour of the noise")
      ->transform(CLI::CheckedTransformer(words<Colour>(4)));
  app.add_flag("--still", request.noise.still_run, "Record a finger at rest");
  app.add_flag("--sigma", request.noise.sigma_given, "State the noise");
  app.add_option("--outliers", request.noise.outliers, "Share of wrong pictures");
  app.add_option("--input-noise-A", request.noise.input_noise, "Noise of the recorded current");
  app.add_option("--weakest", request.weakest, "Smallest strength over the noise")->capture_default_str();
  app.add_option("--strongest", request.strongest, "Largest strength over the noise")->capture_default_str();
  app.add_flag("--at-bound", request.at_bound, "Effects at their physical bounds");
  app.add_flag("--rivals", request.find_confounders, "Search effects that these data cannot distinguish");
  bool joint_angles = false;
  app.add_flag("--joint-angles", joint_angles, "Record theta1_deg and theta2_deg in place of bending_angle_deg");
  app.add_option("--out", folder, "Folder of the set")->required();
  app.add_option("--answer", answer, "File for the answer")->required();
  CLI11_PARSE(app, argc, argv);
  if (joint_angles) request.channels = truth::Camera::joint_angles;
  const LaboratorySet set = make_laboratory_set(request);
  write_laboratory_set(set, folder);
  write_answer(set, answer);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("laboratory_set", [&] { return run(argc, argv); });
}
