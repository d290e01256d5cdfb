#pragma once

#include <span>
#include <string>

#include "coilwright/formats/study/size_json.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/after_search.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::formats {

/// The design of a study at a point as an actuator file (actuator/1) under that name. It has the operating point at
/// which `result`, its evaluation, judged it, if `result` has one.
[[nodiscard]] std::string design_text(const sizing::DesignProblem& problem, std::span<const double> point,
                                      const sizing::DesignResult& result, const std::string& name);

/// The design that a search found, feasible or not, as actuator.json; the search must have found one. A feasible one is
/// read back, evaluated and compared with every limit. Throws std::logic_error if it breaks one.
[[nodiscard]] std::string found_design_text(const sizing::DesignProblem& problem, const sizing::SearchResult& result,
                                            const sizing::DesignResult& best);

/// The report of `size` from its parts, which must outlive it.
[[nodiscard]] SizeReport size_report(const sizing::DesignProblem& problem, const sizing::SearchResult& result,
                                     const sizing::AfterSearch& after);

/// Writes the files of `size`: result.json, evaluations.csv, convergence.csv and, if there is a design, actuator.json.
/// `summary` is what the result says in words, a member of result.json. The caller commits the folder.
void write_size(text::OutputFolder& folder, const sizing::DesignProblem& problem, const SizeReport& report,
                const text::Json& summary);

/// Writes the files of `pareto`: front.csv, evaluations.csv, convergence.csv and result.json, with `summary` as above.
/// The caller commits the folder.
void write_pareto(text::OutputFolder& folder, const sizing::Study& study, const sizing::ParetoResult& result,
                  std::span<const sizing::BrokenPartLimit> broken, const text::Json& summary);

}  // namespace coilwright::formats
