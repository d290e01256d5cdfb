#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "coilwright/formats/study/sweep_json.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/sizing/study/sweep_summary.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

/// Which designs a sweep is of, and which of them are its rows.
struct SweepRequest {
  std::size_t count{};                           ///< designs
  std::optional<sizing::DesignSample> sample{};  ///< nothing: the grid
  sizing::Keep keep = sizing::Keep::all;
};

/// The answer of a sweep, made at once or merged from parts: the same designs give the same bytes.
class SweepAnswer {
 public:
  /// Evaluates the best designs again; both must outlive this.
  SweepAnswer(const sizing::DesignProblem& problem, const SweepRequest& request, const sizing::SweepSummary& summary);
  SweepAnswer(const SweepAnswer&) = delete;
  SweepAnswer& operator=(const SweepAnswer&) = delete;

  /// best.csv, result.json and provenance.json, with the rows that are known only now.
  void write(text::OutputFolder& folder, const results::Provenance& provenance) const;
  void print(bool as_json) const;
  [[nodiscard]] ExitCode code() const;

 private:
  [[nodiscard]] formats::SweepReport report() const;
  [[nodiscard]] text::Json json() const;  // with its summary

  const sizing::DesignProblem& problem_;
  SweepRequest request_;
  const sizing::SweepSummary& summary_;
  std::vector<sizing::Leader> best_;
  std::vector<sizing::BrokenPartLimit> broken_;
};

/// Throws InputError where a variable of the study's file has no values to go through, or the grid is too large.
void require_grid(const sizing::DesignProblem& problem, const std::string& study);

/// Whether the rows of a sweep are known design by design: of the front they are known at the end, of the best never.
[[nodiscard]] constexpr bool has_rows_at_once(sizing::Keep keep) {
  return keep == sizing::Keep::all || keep == sizing::Keep::feasible;
}

/// Opens designs.csv; what writes a row of it. Where a request has no rows, or has them at the end, it writes nothing.
[[nodiscard]] std::function<void(const sizing::SweptDesign&)> write_rows(text::OutputFolder& folder,
                                                                         const sizing::DesignProblem& problem,
                                                                         const SweepRequest& request,
                                                                         const sizing::SweepSummary& summary);

}  // namespace coilwright::cli
