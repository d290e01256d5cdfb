#include <iostream>
#include <variant>

#include "cli/parts/merge/parts.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "cli/search/yield_study.hpp"
#include "coilwright/formats/study/size_json.hpp"
#include "coilwright/report/yield_text.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

text::InputText text_of(const archive::Input& input) {
  return {.file = input.file, .text = input.text};
}

YieldQuestion yield_question_of(const archive::Contents& whole, const std::optional<double>& current) {
  YieldQuestion out{.study = text_of(whole.inputs.at(0)),
                    .actuator = text_of(whole.inputs.at(1)),
                    .changes = whole.changes,
                    .current = current};
  if (whole.inputs.size() > 2) out.posterior = text_of(whole.inputs[2]);
  return out;
}

}  // namespace

ExitCode merge_yield(const MergeOptions& options, const Parts& parts) {
  formats::YieldPart asked;
  std::vector<sizing::Build> builds;
  for_each_part(parts, [&](std::size_t, const PartFolder& part) {
    asked = results_of(part, formats::read_yield_part);
    read_file_of(part, builds_name, {});
    formats::read_builds(part.path / builds_name, builds);
  });
  const sizing::DesignProblem problem(study_of_one(yield_question_of(parts.whole, asked.current)));
  require_figures_of_parts(parts, this_machine(problem));
  const sizing::DesignResult design = problem.evaluate_base();
  const sizing::Yield yield = sizing::yield_from(
      problem.study(), std::get<sizing::EvaluatedDesign>(design),
      {.builds = asked.builds, .worth_builds = asked.worth_builds, .seed = parts.whole.seed.value()}, builds);
  text::OutputFolder folder(options.out);
  folder.write("result.json", formats::to_json(yield).text());
  results::write_provenance(folder, provenance_of_whole(parts.whole));
  take_folder(folder, "result.json", options.force);
  folder.commit("result.json");
  std::cout << (options.json ? formats::to_json(yield).text() : report::to_text(report::document_of(yield)));
  return ExitCode::done;
}

}  // namespace coilwright::cli
