#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/sizing/problem/problem.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/variant.hpp"

namespace coilwright::archive {

/// A value of a variable as an archive keeps it: a number in the unit of the variable's name, or a word.
using Value = text::Variant<double, std::string>;

/// The values of a study's variables at a point of its search, in their order. Points with the same values are the same
/// design and have the same evaluation.
[[nodiscard]] std::vector<Value> values_of(const sizing::Study& study, std::span<const double> point);

/// The point of a study's search with these values, one for each variable; absent if a value is not one of its
/// variable's.
[[nodiscard]] std::optional<std::vector<double>> point_of(const sizing::Study& study, std::span<const Value> values);

/// One evaluation, as an archive keeps it.
struct Row {
  std::int64_t id{};                    ///< place in the order of recording in its table, from 1
  std::int64_t run{};                   ///< the run that recorded it
  std::optional<std::size_t> number{};  ///< place in the order of the search, from 1; absent until a run has ended
  std::string choice{};                 ///< the other modelling choice of the evaluation; empty for the study's own
  std::vector<Value> variables{};       ///< in the order of the archive's columns
  sizing::Evaluation evaluation{};      ///< the evaluation, bit by bit
  std::optional<double> seconds{};      ///< duration of the evaluation; absent if another archive answered
  double ended{};                       ///< time of its end, Unix time in s
  std::string origin{};                 ///< folder of the archive that answered; empty if it was evaluated
};

/// One call of the program that wrote to an archive.
struct Run {
  std::int64_t id{};          ///< from 1
  std::string started{};      ///< "2026-01-31T12:00:00Z"
  std::string ended{};        ///< empty while it runs, and where it was killed
  std::string stop_reason{};  ///< the search's name for the reason, or "complete"; empty if `ended` is
  std::optional<std::size_t> max_evaluations{};  ///< largest number of designs; absent in a sweep
  std::size_t evaluated{};                       ///< designs that it evaluated
  std::size_t answered{};                        ///< designs that this archive answered
  std::size_t reused{};                          ///< designs that other archives answered
};

}  // namespace coilwright::archive
