#include "cli/search/sweep_answer.hpp"

#include <iostream>
#include <stdexcept>

#include "cli/runs/part_run.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/sweep_text.hpp"
#include "coilwright/sizing/study/after_search.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {

// What point_count() throws, in terms of the file.
void require_grid(const sizing::DesignProblem& problem, const std::string& study) {
  for (const sizing::StudyVariable& variable : problem.study().variables)
    if (!value_count(variable))
      throw text::InputError({.file = study,
                              .place = "/variables/" + name_of(variable),
                              .rule = R"(needs "step" or "values" in a sweep, or --sample N)"});
  try {
    (void)problem.point_count();
  } catch (const std::invalid_argument& too_many) {
    throw text::InputError({.file = study, .place = "/variables", .rule = too_many.what()});
  }
}

SweepAnswer::SweepAnswer(const sizing::DesignProblem& problem, const SweepRequest& request,
                         const sizing::SweepSummary& summary)
    : problem_(problem),
      request_(request),
      summary_(summary),
      best_(summary.leaders().all()),
      broken_(sizing::broken_part_limits(problem.study(),
                                         sizing::evaluated_again(problem, sizing::feasible_designs(best_)))) {}

formats::SweepReport SweepAnswer::report() const {
  return {.study = problem_.study(),
          .designs = request_.count,
          .evaluated = summary_.totals().designs,
          .ok = summary_.totals().ok,
          .leaders = best_,
          .broken = broken_,
          .sample = request_.sample,
          .keep = request_.keep,
          .totals = summary_.totals().quantities};
}

text::Json SweepAnswer::json() const {
  return formats::to_json(report()).set("summary", report::to_json(report::document_of(report())));
}

void SweepAnswer::write(text::OutputFolder& folder, const results::Provenance& provenance) const {
  const sizing::Study& study = problem_.study();
  if (request_.keep == sizing::Keep::front) {
    const formats::SweepRow write_row = formats::write_sweep(folder.open(rows_name), study);
    for (const sizing::SweptDesign& design : summary_.front()) write_row(design);
  }
  formats::write_leaders(folder.open("best.csv"), study, best_);
  folder.write("result.json", json().text());
  results::write_provenance(folder, provenance);
}

void SweepAnswer::print(bool as_json) const {
  std::cout << (as_json ? json().text() : report::to_text(report::document_of(report())));
}

ExitCode SweepAnswer::code() const {
  return summary_.leaders().any_feasible() ? ExitCode::done : ExitCode::infeasible;
}

std::function<void(const sizing::SweptDesign&)> write_rows(text::OutputFolder& folder,
                                                           const sizing::DesignProblem& problem,
                                                           const SweepRequest& request,
                                                           const sizing::SweepSummary& summary) {
  if (!has_rows_at_once(request.keep)) return [](const sizing::SweptDesign&) {};
  return [&summary, write_row = formats::write_sweep(folder.open(rows_name), problem.study())](
             const sizing::SweptDesign& design) {
    if (summary.is_row(design)) write_row(design);
  };
}

}  // namespace coilwright::cli
