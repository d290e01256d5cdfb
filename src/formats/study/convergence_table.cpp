#include "coilwright/formats/study/design_tables.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/text/csv/csv_writer.hpp"

namespace coilwright::formats {
namespace {

using namespace sizing;
using namespace text;

// A hypervolume of three objectives takes milliseconds: enough points for a curve.
constexpr std::size_t rows_of_a_front = 200;

// The least violation so far; a design that failed has none.
class LeastViolation {
 public:
  // Whether the design improved it.
  bool learn(const Evaluation& evaluation) {
    if (!evaluation.failure.empty()) return false;
    const double value = violation(evaluation);
    if (least_ && *least_ <= value) return false;
    least_ = value;
    return true;
  }
  [[nodiscard]] const std::optional<double>& value() const { return least_; }

 private:
  std::optional<double> least_;
};

std::vector<Record> in_order_of_evaluation(const Archive& archive) {
  std::vector<Record> records = archive.records();
  std::ranges::stable_sort(records, {}, &Record::number);
  return records;
}

void write_best(std::ostream& out, const Problem& problem, const std::vector<Record>& records) {
  CsvWriter csv(out, {"evaluation", "best_" + problem.objectives.front().name, "least_violation"});
  LeastViolation violation;
  std::optional<double> best;
  for (const Record& record : records) {
    bool changed = violation.learn(record.evaluation);
    if (is_feasible(record.evaluation)) {
      const double value = record.evaluation.objectives.front();
      const bool maximised = problem.objectives.front().sense == Sense::maximise;
      if (!best || (maximised ? value > *best : value < *best)) {
        best = value;
        changed = true;
      }
    }
    if (changed || &record == &records.back())
      csv.row({CsvCell(static_cast<std::int64_t>(record.number)), best, violation.value()});
  }
}

void write_hypervolume(std::ostream& out, const Archive& archive, const std::vector<Record>& records) {
  CsvWriter csv(out, {"evaluation", "front_size", "hypervolume", "least_violation"});
  const std::vector<Objectives> final_front = minimised(archive.problem(), archive.front());
  const FrontFrame frame = final_front.empty() ? FrontFrame{} : frame_of(final_front);
  const std::size_t interval = (records.size() + rows_of_a_front - 1) / rows_of_a_front;
  LeastViolation violation;
  std::vector<Objectives> front;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Evaluation& evaluation = records[i].evaluation;
    violation.learn(evaluation);
    if (is_feasible(evaluation)) {
      Objectives values = minimised(archive.problem(), evaluation);
      const auto covers = [&](const Objectives& other) { return other == values || dominates(other, values); };
      if (std::ranges::none_of(front, covers)) {
        std::erase_if(front, [&](const Objectives& other) { return dominates(values, other); });
        front.push_back(std::move(values));
      }
    }
    if ((i + 1) % interval != 0 && i + 1 != records.size()) continue;
    const auto hypervolume = front.empty() ? std::nullopt : std::optional(normalised_hypervolume(front, frame));
    csv.row({CsvCell(static_cast<std::int64_t>(records[i].number)), CsvCell(static_cast<std::int64_t>(front.size())),
             hypervolume, violation.value()});
  }
}

}  // namespace

void write_convergence(std::ostream& out, const Archive& archive) {
  const std::vector<Record> records = in_order_of_evaluation(archive);
  if (archive.problem().objectives.size() == 1) {
    write_best(out, archive.problem(), records);
  } else {
    write_hypervolume(out, archive, records);
  }
}

}  // namespace coilwright::formats
