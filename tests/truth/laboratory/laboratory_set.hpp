#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "truth/data_set.hpp"
#include "truth/laboratory/built_finger.hpp"
#include "truth/laboratory/recorded_run.hpp"
#include "truth/laboratory/request.hpp"

namespace truth::laboratory {

/// What the diagnosis is not told.
struct LabAnswer {
  Answer common;  ///< seed, hidden effects, stiffness and damping, noise and resolution
  BuiltFinger built;
  Faces declared_faces{};
};

struct LaboratorySet {
  Request request;
  LabAnswer answer;
  std::vector<RecordedRun> runs;
  std::optional<RecordedRun> still{};
};

/// Builds a finger, drives it through the programme and records it. The same request gives the same set. Throws
/// std::invalid_argument for a request that no laboratory has: an exposure or jitter out of range, as many values as
/// there are no effects.
[[nodiscard]] LaboratorySet make_laboratory_set(const Request& request);

/// Writes dataset.json, finger.json, and the CSV files of the runs, with one of the input beside each where the input
/// has one of its own.
void write_laboratory_set(const LaboratorySet& set, const std::filesystem::path& folder);

/// Writes experiment.json (experiment/1), with every fault of the record that the format knows, the input of each run
/// as it was driven, and finger.json, the declared model: what a person could have asked before anything was filmed.
/// Runs in which nobody drives are in it only where its format can say so: on one clock and without exposure.
void write_experiment(const LaboratorySet& set, const std::filesystem::path& folder);

/// Writes everything that is true of the set as JSON; it belongs outside the folder of the set.
void write_answer(const LaboratorySet& set, const std::filesystem::path& file);

}  // namespace truth::laboratory
