#include "cli/bench/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <future>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "cli/model/evaluate_command.hpp"
#include "coilwright/page/design_figures.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/report/simulation/part_limits_text.hpp"
#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/results/page/page_file.hpp"
#include "coilwright/simulation/heating.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/step_motion.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::cli {
namespace {

using simulation::EvaluatedDesign;
using text::Json;

constexpr std::size_t response_samples = 241;
constexpr std::size_t heating_samples = 61;
constexpr int currents = 6;  // on each curve over the current, beside 0 and the operating point

Json in_degrees(double angle) {
  return angle * units::degrees_per_radian;
}

Json response_of(const std::optional<simulation::StepMotion>& motion) {
  if (!motion) return nullptr;
  return Json::object(
      {{"time_s", Json::numbers(motion->times)},
       {"angle_deg", Json::list(motion->states, [](const auto& each) { return in_degrees(each.angles.sum()); })}});
}

Json heating_of(const EvaluatedDesign& design) {
  const simulation::Heating heating = simulation::heating(design, heating_samples);
  Json coil = Json::array(), magnet = Json::array(), times = Json::array();
  for (std::size_t i = 1; i < heating.times.size(); ++i) {
    std::optional<double> hottest_coil, hottest_magnet;
    for (std::size_t part = 0; part < design.design.layout.size(); ++part) {
      const bool is_coil = design.design.layout[part].kind == actuator::ComponentKind::coil;
      const auto at = static_cast<Eigen::Index>(part);
      std::optional<double>& hottest = is_coil ? hottest_coil : hottest_magnet;
      const double degrees = is_coil ? heating.hot_spots[i][at] : heating.means[i][at];
      hottest = std::max(hottest.value_or(degrees), degrees);
    }
    times.add(heating.times[i]);
    coil.add(Json(hottest_coil));
    magnet.add(Json(hottest_magnet));
  }
  return Json::object({{"time_s", std::move(times)},
                       {"coil_degC", std::move(coil)},
                       {"magnet_degC", std::move(magnet)},
                       {"coil_limit_degC", design.design.surroundings.coil_limit},
                       {"magnet_limit_degC", design.design.magnet.temperature_limit}});
}

Json poses_of(const EvaluatedDesign& design, const std::optional<simulation::StepMotion>& motion) {
  Json out = Json::object();
  for (const page::Figure& each : page::pose_figures_of(design, motion))
    out.set(each.id, Json::object({{"title", each.title},
                                   {"description", each.description},
                                   {"svg", std::get<page::Drawing>(each.content).svg}}));
  return out;
}

}  // namespace

Question read_question(const Bench& bench, const std::string& body) {
  const text::Document document = text::parse_json(body, "question");
  return text::read_object(document.root(), [&](text::ObjectReader& in) {
    Question out{.page = in.text_or("page", ""),
                 .design = turned(bench,
                                  [&] {
                                    std::vector<std::string> changes;
                                    for (const text::Node& each : in.elements("changes"))
                                      changes.push_back(each.text());
                                    return changes;
                                  }()),
                 .channel = in.integer_or<std::size_t>("channel", 0, text::non_negative)};
    if (const auto study = in.find("study"))
      out.study = text::read_object(*study, [](text::ObjectReader& parts) {
        Json kept = Json::object();
        for (const char* key : {"variables", "objectives", "constraints"}) kept.set(key, parts.at(key).value());
        return kept;
      });
    return out;
  });
}

Json answer_of(const Bench& bench, const Turned& turned, const NewestFirst::Turn& turn) {
  const EvaluatedDesign design = evaluated(bench, turned);
  turn.require_wanted();
  // Not all of the document that evaluate prints: what would open shut joints takes as long as all the rest.
  const Json cautions = Json::list(report::doubts_of(turned.design),
                                   [](const std::string& each) { return report::to_html(report::Lines{each}); });
  const std::optional<simulation::StepMotion> motion =
      simulation::step_motion(design, page::shown_duration(design), response_samples);
  turn.require_wanted();
  return Json::object({{"evaluation", evaluation_json(design.view(), {})},
                       {"values", knob_values(turned)},
                       {"cautions", cautions},
                       {"poses", poses_of(design, motion)},
                       {"response", response_of(motion)},
                       {"heating", heating_of(design)}});
}

Json curves_of(const Bench& bench, const Turned& turned, const NewestFirst::Turn& turn) {
  const EvaluatedDesign design = evaluated(bench, turned);
  const double own = turned.point.current;
  const double limit = std::max(design.performance.current_limit, 1.2 * std::abs(own));
  std::vector<double> asked{own};
  for (int i = 0; i <= currents; ++i) asked.push_back(std::copysign(limit * i / currents, own));
  std::ranges::sort(asked);
  std::vector<Json> angles(asked.size()), forces(asked.size());
  std::atomic<std::size_t> next = 0;
  const auto strand = [&] {
    for (std::size_t i = next++; i < asked.size(); i = next++) {
      turn.require_wanted();
      simulation::OperatingPoint point = design.point;
      point.current = asked[i];
      const auto result = asked[i] == own
                              ? std::variant<simulation::Performance, simulation::NoPerformance>(design.performance)
                              : simulation::performance_of(design.design, design.assembly, point);
      const auto* found = std::get_if<simulation::Performance>(&result);
      if (found != nullptr && found->free.motion) angles[i] = in_degrees(found->free.motion->steady_angles.sum());
      if (found != nullptr && found->gripping.grasp) forces[i] = found->gripping.grasp->grasp_force;
    }
  };
  std::future<void> other = std::async(std::launch::async, strand);
  strand();
  other.get();
  return Json::object({{"current_A", Json::numbers(asked)},
                       {"steady_angle_deg", Json::array(std::move(angles))},
                       {"grasp_force_N", Json::array(std::move(forces))}});
}

std::string report_of(const Bench& bench, const Turned& turned) {
  const EvaluatedDesign design = evaluated(bench, turned);
  const report::Document document = report::document_of(design.view(), simulation::choice_effects(design.view()));
  return results::html_of(page::evaluation_page(design, document, bench.file.name, results::made_by()));
}

}  // namespace coilwright::cli
