// Writes a measured-data/1 set with hidden effects into a folder, and the answer into a file in another place.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "run_program.hpp"
#include "truth/data_set.hpp"
#include "truth/hidden_effects.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app("Writes a measured-data/1 set from an independent simulation", "truth_set");
  truth::DataSetRequest request;
  std::string folder;
  std::string answer;
  bool list = false;
  app.add_option("--hide", request.hidden, "Effects that the declared model lacks");
  app.add_option("--seed", request.seed, "Random seed (default 1)");
  app.add_option("--weakest", request.weakest, "Smallest strength, in standard deviations of the noise (default 3)");
  app.add_option("--strongest", request.strongest,
                 "Largest strength, in standard deviations of the noise (default 15)");
  bool joint_angles = false;
  app.add_flag("--joint-angles", joint_angles, "Record theta1_deg and theta2_deg in place of bending_angle_deg");
  app.add_flag("--rivals", request.find_confounders,
               "Search effects that these data cannot distinguish from the hidden one");
  app.add_option("--out", folder, "Folder of the set");
  app.add_option("--answer", answer, "File for the answer");
  app.add_flag("--list", list, "List all effects that can be hidden");
  CLI11_PARSE(app, argc, argv);
  if (list) {
    for (const truth::HiddenKind& kind : truth::hidden_kinds())
      fmt::print("{}{}\n", kind.name(), kind.outsider() ? " (outside the catalogue)" : "");
    return 0;
  }
  if (folder.empty() || answer.empty()) {
    fmt::print(stderr, "truth_set: --out and --answer are needed\n");
    return 2;
  }
  if (joint_angles) request.camera = truth::Camera::joint_angles;
  const truth::DataSet set = truth::make_data_set(request);
  truth::write_data_set(set, folder);
  truth::write_answer(set.answer, answer);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("truth_set", [&] { return run(argc, argv); });
}
