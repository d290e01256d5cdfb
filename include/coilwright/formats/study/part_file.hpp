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

/// part.json: one part of a run, and the whole that it belongs to.
struct PartFile {
  sizing::Part part{};
  archive::Contents whole{};  ///< the same in all parts, but for the paths of its inputs; no columns, no physics
  Machine machine{};
  text::Json results{};  ///< of the command
};
[[nodiscard]] text::Json to_json(const PartFile& part);

/// head.json: the machine that gives parts away, for those that make them.
[[nodiscard]] text::Json to_json(const Machine& machine);

/// Both read back; `results` is a node of the document, which must outlive it. Throw text::InputError.
///@{
struct ReadPart {
  text::Document document;
  PartFile file;  ///< without its results
  /// What the part found; a node of `document`.
  [[nodiscard]] text::Node results() const;
};
[[nodiscard]] ReadPart read_part(const std::filesystem::path& path);
[[nodiscard]] Machine read_head(const std::filesystem::path& path);
///@}

/// What a part of a sweep leaves beside its rows.
struct SweepPart {
  std::size_t count{};                           ///< designs of the whole sweep
  sizing::Keep keep = sizing::Keep::all;         ///< which of them are rows
  std::optional<sizing::DesignSample> sample{};  ///< nothing: the grid
  std::string rows_sha256{};                     ///< of its designs.csv; empty where it has none
  sizing::SweepTotals totals{};                  ///< of the part
  std::vector<sizing::SweptDesign> kept{};       ///< SweepSummary::kept() of it
};
[[nodiscard]] text::Json to_json(const SweepPart& part);
[[nodiscard]] SweepPart read_sweep_part(const text::Node& results);

/// What a part of `size` or `pareto` leaves: a search by a seed of its own.
struct SearchPart {
  std::uint64_t seed{};
  std::string stop_reason{};
  std::size_t evaluations{};                 ///< that the search made
  bool feasible{};                           ///< whether `found` keep every limit
  std::vector<sizing::SweptDesign> found{};  ///< the best or the front; with nothing feasible the nearest
};
[[nodiscard]] text::Json to_json(const SearchPart& part);
[[nodiscard]] SearchPart read_search_part(const text::Node& results);

/// What a part of `yield` leaves beside its builds.
struct YieldPart {
  std::size_t builds{};  ///< of the whole yield
  std::size_t worth_builds{};
  std::optional<double> current{};  ///< A, where --current-A gives it
  std::string rows_sha256{};        ///< of its builds.csv
};
[[nodiscard]] text::Json to_json(const YieldPart& part);
[[nodiscard]] YieldPart read_yield_part(const text::Node& results);

/// Builds as CSV with every bit, a row each, and back. Reading throws text::InputError.
///@{
void write_builds(std::ostream& out, std::span<const sizing::Build> builds);
void read_builds(const std::filesystem::path& table, std::vector<sizing::Build>& builds);
///@}

}  // namespace coilwright::formats
