#pragma once

#include <cstddef>
#include <string>

#include "cli/bench/bench.hpp"
#include "cli/bench/jobs.hpp"
#include "cli/bench/newest.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::cli {

/// A question of the page: {"page", "changes": ["gap_mm=1.2"], "channel", "study": {"variables", "objectives",
/// "constraints"}}.
struct Question {
  std::string page{};                       ///< the page that asks, of its own choice
  Turned design;                            ///< the bench's with the changes made
  std::size_t channel{};                    ///< that of a record of the diagnosis
  text::Json study = text::Json::object();  ///< those members of a study/1
};

/// Throws InputError.
[[nodiscard]] Question read_question(const Bench& bench, const std::string& body);

/// What the page shows of a design at once: "evaluation" (what evaluate --json prints, without assumptions), "values"
/// of the knobs, sentences, sections, its step response and its temperatures. Throws Superseded between two steps.
[[nodiscard]] text::Json answer_of(const Bench& bench, const Turned& design, const NewestFirst::Turn& turn);

/// Steady angle and grasp force over the current, each what evaluate says at that current; null where it has none. A
/// design with pressed joints takes two tenths of a second. Throws Superseded between two currents.
[[nodiscard]] text::Json curves_of(const Bench& bench, const Turned& design, const NewestFirst::Turn& turn);

/// The page of a design, as evaluate --report writes it.
[[nodiscard]] std::string report_of(const Bench& bench, const Turned& design);

/// The study that the question asks for, as study/1 beside actuator.json. `spread`: with builds by the usual scatters.
[[nodiscard]] std::string study_text(const Bench& bench, const Question& question, std::size_t evaluations,
                                     bool spread);

/// Long work of a kind: "search" (300 evaluations of the question's study from its design), "limits" (what a step of
/// each variable and a relaxed limit bring) or "yield" (1,000 builds). Its result has "html" and, of a search that
/// found a better design, "changes". Throws InputError for another kind and for a study that cannot be.
[[nodiscard]] LongWork::Work work_of(const Bench& bench, const Question& question, const std::string& kind);

}  // namespace coilwright::cli
