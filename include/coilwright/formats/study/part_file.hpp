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

/// The machine that computes, and what it makes of three designs: machines whose figures differ in a bit give other
/// results.
struct Machine {
  std::string host{};       ///< its name in the network
  std::string processor{};  ///< as the system names it
  std::string figures{};    ///< a JSON text: of each design every number that `evaluate` prints

  /// "desk2 (AMD EPYC 7B13)".
  [[nodiscard]] std::string name() const;
};

/// A file in the folder of a part, as the part wrote it.
struct FileOfPart {
  std::string name{};  ///< a plain file name
  std::uintmax_t bytes{};
  std::string sha256{};
};

/// part.json: one part of a run, the whole that it belongs to, and every file that it has. Nothing of what was found
/// stands here, where no digest guards it.
struct PartFile {
  sizing::Part part{};
  archive::Contents whole{};  ///< the same in all parts, but for the paths of its inputs; no columns, no physics
  Machine machine{};
  std::vector<FileOfPart> files{};
};
[[nodiscard]] text::Json to_json(const PartFile& part);

/// The file of a part that has what it found, for merge.
inline constexpr const char* found_name = "found.json";
/// Its content: the `results` of the command and the digest of part.json without the entry of this file. So neither of
/// the two can be changed alone.
[[nodiscard]] text::Json found_json(const std::string& part_sha256, text::Json results);
/// Reads it back: the results, a node of `found`. Throws text::InputError where it belongs to another part.json.
[[nodiscard]] text::Node results_in(const text::Document& found, const std::string& part_sha256);

/// head.json: the machine that gives parts away, for those that make them.
[[nodiscard]] text::Json to_json(const Machine& machine);

/// Both read back. Throw text::InputError.
///@{
[[nodiscard]] PartFile read_part(const std::filesystem::path& path);
[[nodiscard]] Machine read_head(const std::filesystem::path& path);
///@}

/// What a part of a sweep leaves beside its rows.
struct SweepPart {
  std::size_t count{};                           ///< designs of the whole sweep
  sizing::Keep keep = sizing::Keep::all;         ///< which of them are rows
  std::optional<sizing::DesignSample> sample{};  ///< nothing: the grid
  sizing::SweepTotals totals{};                  ///< of the part; its designs are those of its range, and not kept
  std::vector<sizing::SweptDesign> kept{};       ///< SweepSummary::kept() of it
};
[[nodiscard]] text::Json to_json(const SweepPart& part);
[[nodiscard]] SweepPart read_sweep_part(const text::Node& results);

/// What a part of `size` or `pareto` leaves: a search by a seed of its own.
struct SearchPart {
  std::string stop_reason{};
  std::size_t evaluations{};                 ///< that the search made
  std::vector<sizing::SweptDesign> found{};  ///< the best or the front; with nothing feasible the nearest

  /// Whether what was found keeps every limit.
  [[nodiscard]] bool is_feasible() const { return !found.empty() && sizing::is_feasible(found.front().evaluation); }
};
[[nodiscard]] text::Json to_json(const SearchPart& part);
[[nodiscard]] SearchPart read_search_part(const text::Node& results);

/// What a part of `yield` leaves beside its builds.
struct YieldPart {
  std::size_t builds{};  ///< of the whole yield
  std::size_t worth_builds{};
  std::optional<double> current{};  ///< A, where --current-A gives it
};
[[nodiscard]] text::Json to_json(const YieldPart& part);
[[nodiscard]] YieldPart read_yield_part(const text::Node& results);

/// Builds as CSV with every bit, a row each, and back. Reading throws text::InputError.
///@{
void write_builds(std::ostream& out, std::span<const sizing::Build> builds);
void read_builds(const std::filesystem::path& table, std::vector<sizing::Build>& builds);
///@}

}  // namespace coilwright::formats
