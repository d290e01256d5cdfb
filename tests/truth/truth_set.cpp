// Writes a measured-data/1 set with hidden effects into a folder, and what is hidden into a file elsewhere.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "truth/data_set.hpp"
#include "truth/hidden.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app("A measured-data/1 set from the independent source of truth", "truth_set");
  truth::Order order;
  std::string folder;
  std::string answer;
  bool list = false;
  app.add_option("--hide", order.hidden, "What the declared model does not know of");
  app.add_option("--seed", order.seed, "Of everything that is drawn");
  app.add_option("--weakest", order.weakest, "Smallest strength, in standard deviations of the noise");
  app.add_option("--strongest", order.strongest, "Largest strength");
  bool joint_angles = false;
  app.add_flag("--joint-angles", joint_angles, "theta1_deg, theta2_deg instead of bending_angle_deg");
  app.add_flag("--rivals", order.find_rivals, "Look for what could be taken for the hidden effect");
  app.add_option("--out", folder, "Folder of the set");
  app.add_option("--answer", answer, "File for what is hidden");
  app.add_flag("--list", list, "Names of all that can be hidden");
  CLI11_PARSE(app, argc, argv);
  if (list) {
    for (const truth::HiddenKind& kind : truth::hidden_kinds())
      fmt::print("{}{}\n", kind.id, kind.outsider ? " (outside the catalogue)" : "");
    return 0;
  }
  if (folder.empty() || answer.empty()) {
    fmt::print(stderr, "truth_set: --out and --answer are needed\n");
    return 2;
  }
  if (joint_angles) order.camera = truth::Camera::joint_angles;
  const truth::DataSet set = truth::make_data_set(order);
  truth::write_data_set(set, folder);
  truth::write_answer(set.answer, answer);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "truth_set: {}\n", error.what());
    return 2;
  }
}
