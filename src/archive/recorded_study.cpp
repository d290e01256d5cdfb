#include "coilwright/archive/recorded_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "coilwright/sizing/study/assumption_effects.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/one_line.hpp"

namespace coilwright::archive {
namespace {

// SQLite keeps every bit of a number, and has none that is not a number.
bool can_be_recorded(const sizing::Evaluation& evaluation) {
  const auto is_nan = [](double value) { return std::isnan(value); };
  return !is_nan(evaluation.infeasibility) && std::ranges::none_of(evaluation.objectives, is_nan) &&
         std::ranges::none_of(evaluation.constraints, is_nan) &&
         std::ranges::none_of(evaluation.quantities, [&](const auto& value) { return value && is_nan(*value); });
}

double unix_time() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

// The values of a study's variables in the order of another archive's columns.
std::vector<Value> in_order_of(const Contents& contents, const sizing::Study& study, std::span<const Value> values) {
  std::vector<Value> ordered;
  for (const Column& column : contents.columns) {
    if (column.role != Role::variable) continue;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (sizing::name_of(study.variables[i]) == column.name) ordered.push_back(values[i]);
  }
  return ordered;
}

// The values of another archive's variables in the order of a study, which has variables of the same names.
std::vector<Value> in_order_of(const sizing::Study& study, const Contents& contents, std::span<const Value> values) {
  std::vector<Value> ordered;
  for (const sizing::StudyVariable& variable : study.variables) {
    std::size_t k = 0;
    for (const Column& column : contents.columns) {
      if (column.role != Role::variable) continue;
      if (column.name == sizing::name_of(variable)) ordered.push_back(values[k]);
      ++k;
    }
  }
  return ordered;
}

// The quantities of a study in its order, from a design of another archive that has all of them.
std::vector<std::optional<double>> quantities_of(const Contents& contents, const sizing::Study& study,
                                                 const std::vector<std::optional<double>>& values) {
  std::vector<std::optional<double>> ordered(study.quantities.size());
  std::size_t k = 0;
  for (const Column& column : contents.columns) {
    if (column.role != Role::quantity) continue;
    for (std::size_t i = 0; i < ordered.size(); ++i)
      if (study.quantities[i].name == column.name) ordered[i] = values.at(k);
    ++k;
  }
  return ordered;
}

// The first number in which two evaluations differ, by its name: what was recorded, and what came out.
struct Difference {
  std::string name, recorded, again;
};

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "none";
}

Difference difference_of(const sizing::Study& study, const sizing::Evaluation& recorded,
                         const sizing::Evaluation& again) {
  if (recorded.failure != again.failure)
    return {"reason", text::in_quotes(recorded.failure), text::in_quotes(again.failure)};
  const auto in = [](const auto& values, std::size_t i) -> std::optional<double> {
    return i < values.size() ? std::optional<double>(values[i]) : std::nullopt;
  };
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    if (in(recorded.objectives, i) != in(again.objectives, i))
      return {study.objectives[i].quantity.name, shown(in(recorded.objectives, i)), shown(in(again.objectives, i))};
  for (std::size_t i = 0; i < study.limits.size(); ++i)
    if (in(recorded.constraints, i) != in(again.constraints, i))
      return {sizing::name_of(study.limits[i]) + ", relative to its limit", shown(in(recorded.constraints, i)),
              shown(in(again.constraints, i))};
  const auto quantity = [](const sizing::Evaluation& of, std::size_t i) {
    return i < of.quantities.size() ? of.quantities[i] : std::nullopt;
  };
  for (std::size_t i = 0; i < study.quantities.size(); ++i)
    if (quantity(recorded, i) != quantity(again, i))
      return {study.quantities[i].name, shown(quantity(recorded, i)), shown(quantity(again, i))};
  return {"infeasibility", shown(recorded.infeasibility), shown(again.infeasibility)};
}

// What a study makes of a design that another archive knows; nothing where only the design itself can say.
std::optional<sizing::Evaluation> worked_out(const sizing::DesignProblem& problem, const Contents& contents,
                                             sizing::Evaluation recorded) {
  if (recorded.quantities.empty()) return recorded;
  return problem.assess(quantities_of(contents, problem.study(), recorded.quantities));
}

}  // namespace

RecordedStudy::RecordedStudy(const sizing::DesignProblem& problem, Sources sources)
    : problem_(problem), sources_(std::move(sources)) {
  if (!sources_.writer) throw std::invalid_argument("sources.writer: must not be empty");
}

sizing::Problem RecordedStudy::problem() {
  sizing::Problem recorded = problem_.problem();
  recorded.evaluate = [this](std::span<const double> point) { return evaluate(point); };
  return recorded;
}

sizing::Evaluation RecordedStudy::evaluate(std::span<const double> point, std::optional<std::size_t> number) {
  std::vector<Value> values = values_of(problem_.study(), point);
  if (sources_.known) {
    if (std::optional<Row> row = sources_.known->find(values))
      return counted(std::move(row->evaluation), &Counts::answered);
  }
  if (std::optional<Answer> answer = reused(values)) {
    record({.number = number,
            .variables = std::move(values),
            .evaluation = answer->evaluation,
            .origin = std::move(answer->origin)});
    return counted(std::move(answer->evaluation), &Counts::reused);
  }
  return counted(evaluate_anew(problem_, point, {.number = number, .variables = std::move(values)}),
                 &Counts::evaluated);
}

sizing::Evaluation RecordedStudy::evaluate_under(const std::string& choice, const sizing::DesignProblem& other,
                                                 std::span<const double> point) {
  std::vector<Value> values = values_of(problem_.study(), point);
  if (sources_.known)
    if (std::optional<Row> row = sources_.known->find(values, choice)) return std::move(row->evaluation);
  return evaluate_anew(other, point, {.choice = choice, .variables = std::move(values)});
}

sizing::Evaluation RecordedStudy::evaluate_anew(const sizing::DesignProblem& problem, std::span<const double> point,
                                                Row row) {
  const auto begin = std::chrono::steady_clock::now();
  row.evaluation = problem.assess(problem.evaluate(point));
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  sizing::Evaluation evaluation = row.evaluation;
  record(std::move(row));
  return evaluation;
}

// A design that cannot be built says the same in every study; one that lacks what this study asks for says why only
// when it is evaluated.
std::optional<RecordedStudy::Answer> RecordedStudy::reused(std::span<const Value> values) const {
  for (const std::shared_ptr<const Reader>& other : sources_.others) {
    const Contents& contents = other->contents();
    std::optional<Row> row = other->find(in_order_of(contents, problem_.study(), values));
    if (!row) continue;
    std::optional<sizing::Evaluation> evaluation = worked_out(problem_, contents, std::move(row->evaluation));
    if (evaluation) return Answer{.evaluation = *std::move(evaluation), .origin = other->path().parent_path().string()};
  }
  return std::nullopt;
}

sizing::Evaluation RecordedStudy::counted(sizing::Evaluation evaluation, std::size_t Counts::*source) {
  const std::scoped_lock lock(guard_);
  ++(counts_.*source);
  if (sizing::is_feasible(evaluation)) {
    ++counts_.feasible;
    const double value = evaluation.objectives.front();
    const bool maximised = problem_.study().objectives.front().sense == sizing::Sense::maximise;
    if (!counts_.best || (maximised ? value > *counts_.best : value < *counts_.best)) counts_.best = value;
  }
  return evaluation;
}

void RecordedStudy::record(Row row) {
  if (!can_be_recorded(row.evaluation)) return;
  row.ended = unix_time();
  sources_.writer->add(std::move(row));
}

void RecordedStudy::require_same_again(std::span<const double> point, const std::string& choice) const {
  const std::vector<Value> values = values_of(problem_.study(), point);
  const auto require = [&](const Reader& archive, const Row& row, const std::optional<sizing::Evaluation>& said,
                           const std::string& cure) {
    const std::optional<sizing::Evaluation> again = evaluated_again(problem_, archive.contents(), row);
    if (!said || !again || *again == *said) return;
    const Difference difference = difference_of(problem_.study(), *said, *again);
    throw text::InputError({.file = archive.path().string(),
                            .place = fmt::format("row {} of {}", row.id, choice.empty() ? "designs" : "other_choices"),
                            .rule = fmt::format("the answer rests on this design, and its {} is {} when it is "
                                                "evaluated again, not as recorded: {}",
                                                difference.name, difference.again, cure),
                            .value = difference.recorded});
  };
  if (sources_.known)
    if (const std::optional<Row> row = sources_.known->find(values, choice))
      return require(*sources_.known, *row, row->evaluation, "--force starts anew");
  if (!choice.empty()) return;  // which no other archive answers
  for (const std::shared_ptr<const Reader>& other : sources_.others)
    if (const auto row = other->find(in_order_of(other->contents(), problem_.study(), values)))
      require(*other, *row, worked_out(problem_, other->contents(), row->evaluation),
              "leave out --reuse of its folder");
}

Counts RecordedStudy::counts() const {
  const std::scoped_lock lock(guard_);
  return counts_;
}

void RecordedStudy::number(const std::filesystem::path& path, std::span<const sizing::Record> records) {
  sources_.writer->flush();
  if (sources_.writer->failure()) return;
  std::vector<std::pair<std::int64_t, std::size_t>> numbers;
  {
    const Reader written(path);
    for (const sizing::Record& record : records) {
      if (record.number == 0) continue;
      if (const std::optional<Row> row = written.find(values_of(problem_.study(), record.point)))
        numbers.emplace_back(row->id, record.number);
    }
  }
  std::ranges::sort(numbers);
  sources_.writer->number(numbers);
}

std::optional<sizing::Evaluation> evaluated_again(const sizing::DesignProblem& problem, const Contents& contents,
                                                  const Row& row) {
  const std::optional<std::vector<double>> point =
      point_of(problem.study(), in_order_of(problem.study(), contents, row.variables));
  if (!point) return std::nullopt;
  if (row.choice.empty()) return problem.assess(problem.evaluate(*point));
  for (const actuator::OtherChoice& choice : actuator::other_choices(problem.study().base)) {
    if (sizing::name_of(choice) != row.choice) continue;
    const sizing::DesignProblem other = sizing::under(problem, choice);
    return other.assess(other.evaluate(*point));
  }
  return std::nullopt;
}

std::vector<std::int64_t> designs_with_other_numbers(const sizing::DesignProblem& problem, const Contents& contents,
                                                     std::span<const Row> designs) {
  std::vector<std::int64_t> differing;
  for (const Row& row : designs) {
    const std::optional<sizing::Evaluation> said = worked_out(problem, contents, row.evaluation);
    if (!said) continue;
    const std::optional<sizing::Evaluation> again = evaluated_again(problem, contents, row);
    if (again && *again != *said) differing.push_back(row.id);
  }
  return differing;
}

}  // namespace coilwright::archive
