#include <optional>
#include <ostream>
#include <string_view>

#include "cli/parts/merge/parts.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/search/archive/opened_archive.hpp"
#include "cli/search/sweep_answer.hpp"
#include "coilwright/formats/study/design_tables.hpp"

namespace coilwright::cli {
namespace {

// All rows but the header, as they are.
void copy_rows(const PartFolder& part, std::ostream& out) {
  bool in_header = true;
  read_file_of(part, rows_name, [&](std::string_view block) {
    const std::size_t end = in_header ? block.find('\n') : 0;
    if (end == std::string_view::npos) return;
    out << block.substr(end + (in_header ? 1 : 0));
    in_header = false;
  });
}

}  // namespace

ExitCode merge_sweep(const MergeOptions& options, const Parts& parts) {
  const sizing::DesignProblem problem = problem_of(parts.whole);
  require_figures_of_parts(parts, this_machine(problem));
  std::optional<SweepRequest> request;
  std::optional<sizing::SweepSummary> summary;
  text::OutputFolder folder(options.out);
  std::ostream* rows = nullptr;
  for_each_part(parts, [&](std::size_t number, const PartFolder& from) {
    formats::SweepPart part = results_of(from, formats::read_sweep_part);
    if (!request) {
      request = {.count = part.count, .sample = part.sample, .keep = part.keep};
      summary.emplace(problem, part.keep);
      if (has_rows_at_once(part.keep)) rows = &folder.open(rows_name);
      if (rows != nullptr) (void)formats::write_sweep(*rows, problem.study());
    }
    const sizing::IndexRange range = sizing::range_of({.number = number, .of = parts.folders.size()}, request->count);
    part.totals.designs = range.end - range.first;
    summary->consider(part.totals, part.kept);
    if (rows != nullptr) copy_rows(from, *rows);
  });
  const SweepAnswer answer(problem, request.value(), summary.value());
  answer.write(folder, provenance_of_whole(parts.whole));
  take_folder(folder, "result.json", options.force);
  folder.commit("result.json");
  answer.print(options.json);
  return answer.code();
}

}  // namespace coilwright::cli
