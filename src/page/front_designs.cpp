#include "page/front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/page/design_figures.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::page {
namespace {

using sizing::DesignProblem;
using sizing::EvaluatedDesign;
using text::Json;

constexpr std::size_t samples = 201;

// The same program gives the same bits; another version of it may move a number by what its log says, which is more.
constexpr double same_number = 1e-6;

bool agrees(const sizing::Evaluation& evaluation, const FrontTable& front, std::size_t row) {
  if (!evaluation.failure.empty() || evaluation.objectives.size() != front.objectives.size()) return false;
  for (std::size_t i = 0; i < front.objectives.size(); ++i) {
    const std::optional<double> told = front.texts.number(front.objectives[i], row);
    if (!told || std::abs(evaluation.objectives[i] - *told) > same_number * std::abs(*told)) return false;
  }
  return true;
}

// One duration for all, so that their responses can be laid over each other: the middle one of what each is worth.
double common_duration(const std::vector<EvaluatedDesign>& designs) {
  std::vector<double> each;
  for (const EvaluatedDesign& design : designs) each.push_back(shown_duration(design));
  std::ranges::nth_element(each, each.begin() + static_cast<std::ptrdiff_t>(each.size() / 2));
  return each[each.size() / 2];
}

Json poses_of(const EvaluatedDesign& design, const std::optional<simulation::StepMotion>& motion) {
  Json out = Json::array();
  for (const Figure& figure : pose_figures_of(design, motion))
    out.add(Json::object({{"title", figure.title},
                          {"description", figure.description},
                          {"svg", std::get<Drawing>(figure.content).svg}}));
  return out;
}

// Bending angle in deg, to a hundredth: for a picture.
Json angles_of(const simulation::StepMotion& motion) {
  Json out = Json::array();
  for (const simulation::State& state : motion.states)
    out.add(std::round(100.0 * state.angles.sum() * units::degrees_per_radian) / 100.0);
  return out;
}

// The file of a row; its operating point is the study's with the row's current, unless a cell's circuit says both.
std::optional<std::string> actuator_of(const DesignProblem& problem, const FrontTable& front, std::size_t row) {
  const sizing::Study& study = problem.study();
  const std::optional<std::vector<double>> point = point_of(study, front, row);
  if (!point) return std::nullopt;
  std::optional<actuator::OperatingPoint> operating;
  if (front.texts.has("current_A") && !std::holds_alternative<sizing::DrivenCurrent>(study.current)) {
    operating = study.operating;
    operating->current = front.texts.required_number("current_A", row);
  }
  const std::string name = fmt::format("{}, row {} of its front", study.name, row + 1);
  return formats::to_json(problem.design_at(*point), name, operating).text();
}

}  // namespace

Json texts_json(const std::vector<std::string>& texts) {
  return Json::array({texts.begin(), texts.end()});
}

std::optional<EvaluatedDesign> evaluated_row(const DesignProblem& problem, const FrontTable& front, std::size_t row) {
  const std::optional<std::vector<double>> point = point_of(problem.study(), front, row);
  if (!point) return std::nullopt;
  sizing::DesignResult result = problem.evaluate(*point);
  if (!agrees(problem.assess(result), front, row)) return std::nullopt;
  return std::get<EvaluatedDesign>(std::move(result));
}

Json front_pictures(const sizing::Study& study, const FrontTable& front, std::size_t most) {
  const DesignProblem problem(study);
  std::vector<std::size_t> rows;
  std::vector<EvaluatedDesign> designs;
  int differ = 0;
  for (const std::size_t row : even_choice(front.rows(), most)) {
    std::optional<EvaluatedDesign> design = evaluated_row(problem, front, row);
    if (!design) {
      ++differ;
      continue;
    }
    rows.push_back(row);
    designs.push_back(*std::move(design));
  }
  Json out = Json::object({{"differ", differ}, {"samples", samples}});
  Json row_numbers = Json::array();
  Json poses = Json::array();
  Json angles = Json::array();
  const double duration = designs.empty() ? 1.0 : common_duration(designs);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const std::optional<simulation::StepMotion> motion = simulation::step_motion(designs[i], duration, samples);
    row_numbers.add(rows[i]);
    poses.add(poses_of(designs[i], motion));
    angles.add(motion ? angles_of(*motion) : Json::array());
  }
  out.set("duration_s", duration).set("rows", std::move(row_numbers)).set("poses", std::move(poses));
  return out.set("angle_deg", std::move(angles));
}

Json front_actuators(const sizing::Study& study, const FrontTable& front) {
  const DesignProblem problem(study);
  std::vector<std::optional<std::vector<std::string>>> files;
  for (std::size_t row = 0; row < front.rows(); ++row) {
    const std::optional<std::string> text = actuator_of(problem, front, row);
    files.push_back(text ? std::optional(text::lines_of(*text)) : std::nullopt);
  }
  const auto first = std::ranges::find_if(files, [](const auto& file) { return file.has_value(); });
  if (first == files.end()) return {};
  const std::vector<std::string>& base = **first;
  std::vector<std::size_t> places;
  for (std::size_t line = 0; line < base.size(); ++line)
    if (std::ranges::any_of(files, [&](const auto& file) {
          return file && file->size() == base.size() && (*file)[line] != base[line];
        }))
      places.push_back(line);
  Json texts = Json::array();
  Json whole = Json::object();
  for (std::size_t row = 0; row < files.size(); ++row) {
    const auto& file = files[row];
    Json of_row = Json::array();
    if (file && file->size() == base.size()) {
      for (const std::size_t place : places) of_row.add((*file)[place]);
    } else {
      whole.set(std::to_string(row), file ? texts_json(*file) : Json());
    }
    texts.add(std::move(of_row));
  }
  Json place_numbers = Json::array();
  for (const std::size_t place : places) place_numbers.add(place);
  return Json::object({{"lines", texts_json(base)},
                       {"places", std::move(place_numbers)},
                       {"texts", std::move(texts)},
                       {"whole", std::move(whole)}});
}

}  // namespace coilwright::page
