#include <fstream>
#include <ostream>
#include <string>

#include "cli/archive/opened_archive.hpp"
#include "cli/outputs.hpp"
#include "cli/part_run.hpp"
#include "cli/sweep_answer.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/text/opened_file.hpp"
#include "parts.hpp"

namespace coilwright::cli {
namespace {

// All rows but the header, as they are.
void copy_rows(const std::filesystem::path& table, std::ostream& out) {
  std::ifstream rows = text::opened(table);
  std::string header;
  std::getline(rows, header);
  text::copy_rest(rows, table, out);
}

}  // namespace

ExitCode merge_sweep(const MergeOptions& options, const Parts& parts) {
  const sizing::DesignProblem problem = problem_of(parts.whole);
  require_figures_of_parts(parts, this_machine(problem));
  const formats::SweepPart first =
      formats::read_sweep_part(formats::read_part(parts.folders.front() / part_name).results());
  const SweepRequest request{.count = first.count, .sample = first.sample, .keep = first.keep};
  sizing::SweepSummary summary(problem, request.keep);
  text::OutputFolder folder(options.out);
  std::ostream* rows = first.rows_sha256.empty() ? nullptr : &folder.open(rows_name);
  if (rows != nullptr) (void)formats::write_sweep(*rows, problem.study());
  for_each_part(parts, [&](std::size_t, const std::filesystem::path& from, const text::Node& results) {
    const formats::SweepPart part = formats::read_sweep_part(results);
    summary.consider(part.totals, part.kept);
    if (rows == nullptr) return;
    require_written(from / rows_name, part.rows_sha256);
    copy_rows(from / rows_name, *rows);
  });
  const SweepAnswer answer(problem, request, summary);
  answer.write(folder, provenance_of_whole(parts.whole));
  keep_others(folder, options.force);
  folder.commit("result.json");
  answer.print(options.json);
  return answer.code();
}

}  // namespace coilwright::cli
