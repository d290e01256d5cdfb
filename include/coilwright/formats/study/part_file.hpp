#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/archive/contents.hpp"
#include "coilwright/sizing/problem/problem.hpp"
#include "coilwright/sizing/study/part.hpp"
#include "coilwright/sizing/study/sweep_summary.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The machine that computes, and its figures of three designs. Machines whose figures differ in a bit give other
/// results.
struct Machine {
  std::string host{};       ///< name in the network
  std::string processor{};  ///< the system's name for the processor
  std::string figures{};    ///< a JSON text: of each design every number that `evaluate` prints

  /// The machine's name: "desk2 (AMD EPYC 7B13)".
  [[nodiscard]] std::string name() const;
};

/// A file in the folder of a part, as the part wrote it.
struct FileOfPart {
  std::string name{};  ///< a plain file name
  std::uintmax_t bytes{};
  std::string sha256{};
};

/// part.json: one part of a run, the whole to which it belongs, and every file that it has. Results are not in it,
/// because no digest would guard them here.
struct PartFile {
  sizing::Part part{};
  archive::Contents whole{};  ///< equal in all parts except for the paths of its inputs; without columns and physics
  Machine machine{};
  std::vector<FileOfPart> files{};
};
[[nodiscard]] text::Json to_json(const PartFile& part);

/// The file of a part that holds its results for merge.
inline constexpr const char* found_name = "found.json";
/// The content of that file: the `results` of the command and the digest of part.json without the entry of this file.
/// So neither of the two can be changed alone.
[[nodiscard]] text::Json found_json(const std::string& part_sha256, text::Json results);
/// Reads the results back, as a node of `found`. Throws text::InputError if it belongs to another part.json.
[[nodiscard]] text::Node results_in(const text::Document& found, const std::string& part_sha256);

/// head.json: the machine that distributes parts.
[[nodiscard]] text::Json to_json(const Machine& machine);

/// Reads both files back. Throws text::InputError. @{
[[nodiscard]] PartFile read_part(const std::filesystem::path& path);
[[nodiscard]] Machine read_head(const std::filesystem::path& path);
///@}

/// The results of a part of a sweep, beside its rows.
struct SweepPart {
  std::size_t count{};                           ///< designs of the whole sweep
  sizing::Keep keep = sizing::Keep::all;         ///< kind of designs that are rows
  std::optional<sizing::DesignSample> sample{};  ///< absent: the grid
  sizing::SweepTotals totals{};  ///< totals of the part; its designs are those of its range, whether kept or not
  std::vector<sizing::SweptDesign> kept{};  ///< SweepSummary::kept() of it
};
[[nodiscard]] text::Json to_json(const SweepPart& part);
[[nodiscard]] SweepPart read_sweep_part(const text::Node& results);

/// The result of a part of `size` or `pareto`: a search with a seed of its own.
struct SearchPart {
  std::string stop_reason{};
  std::size_t evaluations{};                 ///< evaluations of the search
  std::vector<sizing::SweptDesign> found{};  ///< the best or the front; with nothing feasible the nearest

  /// Whether the best design found keeps every limit.
  [[nodiscard]] bool is_feasible() const { return !found.empty() && sizing::is_feasible(found.front().evaluation); }
};
[[nodiscard]] text::Json to_json(const SearchPart& part);
[[nodiscard]] SearchPart read_search_part(const text::Node& results);

/// The results of a part of `yield`, beside its builds.
struct YieldPart {
  std::size_t builds{};  ///< of the whole yield
  std::size_t worth_builds{};
  std::optional<double> current{};  ///< A, where --current-A gives it
};
[[nodiscard]] text::Json to_json(const YieldPart& part);
[[nodiscard]] YieldPart read_yield_part(const text::Node& results);

/// Writes builds as CSV with every bit, a row each, and reads them back. Reading throws text::InputError. @{
void write_builds(std::ostream& out, std::span<const sizing::Build> builds);
void read_builds(const std::filesystem::path& table, std::vector<sizing::Build>& builds);
///@}

}  // namespace coilwright::formats
