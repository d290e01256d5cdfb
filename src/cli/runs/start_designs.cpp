#include "cli/runs/start_designs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "cli/runs/archive_contents.hpp"
#include "coilwright/archive/reader.hpp"
#include "coilwright/archive/row.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/sizing/problem/front.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

using archive::Value;
using sizing::StudyVariable;

// Designs of a sweep are as many as its grid has; those that others beat are dropped whenever so many are held.
constexpr std::size_t designs_held = 100'000;

struct AnswerDesign {
  sizing::Objectives minimised;
  std::vector<Value> variables;
};

text::InputError no_start(const archive::Reader& found, std::string rule) {
  return text::InputError({.file = found.path().string(), .rule = std::move(rule)});
}

// Those that no other one beats. The order of recording depends on the threads, this one does not.
void keep_best(std::vector<AnswerDesign>& designs) {
  std::ranges::sort(designs, {}, [](const AnswerDesign& each) { return std::tie(each.minimised, each.variables); });
  std::vector<sizing::Objectives> values;
  values.reserve(designs.size());
  for (const AnswerDesign& each : designs) values.push_back(each.minimised);
  std::vector<AnswerDesign> best;
  for (const std::size_t i : sizing::non_dominated(values)) best.push_back(std::move(designs[i]));
  designs = std::move(best);
}

std::vector<AnswerDesign> answer_in(const archive::Reader& found) {
  std::vector<double> signs;
  for (const archive::Column& column : found.contents().columns)
    if (column.role == archive::Role::objective) signs.push_back(column.meaning == "maximise" ? -1.0 : 1.0);
  if (signs.empty())
    throw no_start(found,
                   "has no objective, by which one of its designs would be the best to start from: give the "
                   "folder of a run with objectives");
  std::vector<AnswerDesign> designs;
  found.each({.where = "status = 'ok'"}, [&](const archive::Row& row) {
    AnswerDesign& design = designs.emplace_back(row.evaluation.objectives, row.variables);
    for (std::size_t i = 0; i < signs.size(); ++i) design.minimised[i] *= signs[i];
    if (designs.size() >= designs_held) keep_best(designs);
  });
  keep_best(designs);
  if (designs.empty())
    throw no_start(found, "must have a design that keeps its limits to start from, and has none: leave out --start");
  return designs;
}

// The place of each of the study's variables among those of the archive.
std::vector<std::size_t> matched_names(const archive::Reader& found, const sizing::Study& study) {
  std::vector<std::string> names;
  for (const archive::Column& column : found.contents().columns)
    if (column.role == archive::Role::variable) names.push_back(column.name);
  std::vector<std::string> others = names;
  std::vector<std::size_t> places;
  for (const StudyVariable& variable : study.variables) {
    const auto place = std::ranges::find(names, name_of(variable));
    if (place == names.end())
      throw no_start(found, fmt::format("must have {}, which the study varies: start from a run that varies it, too",
                                        name_of(variable)));
    places.push_back(static_cast<std::size_t>(place - names.begin()));
    std::erase(others, *place);
  }
  if (!others.empty())
    std::cerr << fmt::format(
        "coilwright: {}: varies {}, which this study does not: its designs start with what the "
        "study has there\n",
        found.path().string(), fmt::join(others, ", "));
  return places;
}

std::string shown(const Value& value) {
  return std::visit([](const auto& each) { return fmt::format("{}", each); }, value);
}

// Beyond what a search rounds the values of a range to.
bool differ(const Value& a, const Value& b) {
  const double* x = std::get_if<double>(&a);
  const double* y = std::get_if<double>(&b);
  if (x == nullptr || y == nullptr) return a != b;
  return std::abs(*x - *y) > 1e-9 * std::max(std::abs(*x), std::abs(*y));
}

// How many designs a study does not take as they are, and the first of them.
struct Told {
  std::size_t count{};
  std::string first;

  void add(std::string what) {
    if (count++ == 0) first = std::move(what);
  }
};

std::vector<std::vector<double>> points_in(const archive::Reader& found, const sizing::Study& study) {
  const std::vector<AnswerDesign> designs = answer_in(found);
  const std::vector<std::size_t> places = matched_names(found, study);
  std::vector<std::vector<double>> points;
  Told moved, left_out;
  for (const AnswerDesign& design : designs) {
    std::vector<double> point;
    for (const StudyVariable& variable : study.variables) {
      const Value& value = design.variables.at(places[point.size()]);
      const auto as_seen = [](const auto& each) { return sizing::VariableValue(each); };
      const std::optional<double> near = sizing::nearest_coordinate(variable, std::visit(as_seen, value));
      if (!near) {
        left_out.add(fmt::format("{} {}", name_of(variable), shown(value)));
        break;
      }
      point.push_back(*near);
    }
    if (point.size() < study.variables.size()) continue;
    const std::vector<Value> here = archive::values_of(study, point);
    for (std::size_t i = 0; i < here.size(); ++i) {
      const Value& value = design.variables.at(places[i]);
      if (!differ(value, here[i])) continue;
      moved.add(fmt::format("{} {}, here {}", name_of(study.variables[i]), shown(value), shown(here[i])));
      break;
    }
    points.push_back(std::move(point));
  }
  if (points.empty())
    throw no_start(found, fmt::format("must have a design that this study takes, and it takes no {}: add it to the "
                                      "study's values",
                                      left_out.first));
  const auto say = [&](const Told& told, std::string_view what) {
    if (told.count > 0)
      std::cerr << fmt::format("coilwright: {}: {} of {} designs {} (first {})\n", found.path().string(), told.count,
                               designs.size(), what, told.first);
  };
  say(moved, "have values that this study does not take, and start at the nearest that it takes");
  say(left_out, "are left out, as this study does not take them");
  return points;
}

// The record of the designs: the archive itself grows with every call of its run.
results::InputRecord record_of(const archive::Reader& found, const sizing::Study& study,
                               const std::vector<std::vector<double>>& points) {
  std::string text;
  for (const std::vector<double>& point : points) {
    std::vector<std::string> words;
    for (const Value& value : archive::values_of(study, point)) words.push_back(shown(value));
    text += fmt::format("{}\n", fmt::join(words, ","));
  }
  return {.file = found.path().string(), .sha256 = results::sha256(text), .text = text};
}

}  // namespace

void add_starts(std::span<const std::string> folders, StudyInput& input) {
  std::vector<std::vector<double>>& starts = input.study.starts;
  for (const std::string& folder : folders) {
    const archive::Reader found = archive_of("--start", folder);
    const std::vector<std::vector<double>> points = points_in(found, input.study);
    input.provenance.starts.push_back(record_of(found, input.study, points));
    for (const std::vector<double>& point : points)
      if (std::ranges::find(starts, point) == starts.end()) starts.push_back(point);
  }
  const std::size_t most = input.study.search.max_evaluations;
  if (!starts.empty() && starts.size() >= most)
    throw text::argument_error(
        "--start", fmt::format("must bring fewer designs ({}) than max_evaluations ({}), as the study's own actuator "
                               "comes first: give --max-evaluations",
                               starts.size(), most));
}

}  // namespace coilwright::cli
