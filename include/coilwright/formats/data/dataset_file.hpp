#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/replay/tolerances.hpp"

namespace coilwright::formats {

/// What the folder of a data set holds.
struct DatasetFile {
  std::string file;  ///< path of dataset.json, for errors about it
  measurement::data::Dataset data{};
  std::vector<std::filesystem::path> run_files{};   ///< of all its runs, and of their inputs
  std::vector<std::string> calibrate{};             ///< numbers of the declared model that may be fitted anew
  measurement::replay::Tolerances tolerances{};     ///< how well its declared numbers are known
  std::optional<std::filesystem::path> actuator{};  ///< the declared model, where the set names one; not opened
};

/// Reads a measured-data/1 set: its dataset.json (or the folder of it) and every CSV file it names. Validate runs are
/// read, so that a fault of their files is told at once, but nothing is concluded from their numbers: warnings, and
/// refusals of what cannot be right, are about fit and still runs only. A set that names no validate run has some held
/// out by measurement::data::with_runs_held_out(). Throws InputError naming file, place and rule.
[[nodiscard]] DatasetFile read_dataset(const std::filesystem::path& path);

/// The same for the text of a dataset.json; its runs' files count from the folder of `file`.
[[nodiscard]] DatasetFile parse_dataset(std::string_view text, std::string file);

}  // namespace coilwright::formats
