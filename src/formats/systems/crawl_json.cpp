#include "coilwright/formats/systems/crawl_json.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "coilwright/units/angle.hpp"

namespace coilwright::formats {
namespace {

std::string point_name(std::size_t i, std::size_t count) {
  if (i == 0) return "rear_end";
  return i + 1 == count ? "front_end" : fmt::format("joint{}", i);
}

}  // namespace

CrawlRows rows_of(const systems::Crawler& crawler, const systems::Crawl& crawl, const systems::CrawlHeat& heat) {
  const systems::CrawlPowers& powers = crawl.powers;
  CrawlRows rows{{"crawler_mass_g", crawler.mass() * 1e3},
                 {"speed_mm_s", crawl.speed * 1e3},
                 {"speed_scatter_mm_s", crawl.speed_scatter * 1e3},
                 {"coil_current_A", crawl.pulse_current},
                 {"mean_cell_current_A", crawl.mean_current},
                 {"power_W", powers.electrical},
                 {"run_time_s", crawl.run_time},
                 {"distance_per_charge_m", crawl.distance_per_charge},
                 {"largest_bending_deg", crawl.largest_bending * units::degrees_per_radian},
                 {"smallest_bending_deg", crawl.smallest_bending * units::degrees_per_radian}};
  for (std::size_t i = 0; i < crawl.lifts.size(); ++i)
    rows.emplace_back(fmt::format("lift_{}_mm", point_name(i, crawl.lifts.size())), crawl.lifts[i] * 1e3);
  for (const auto& [key, watts] : {std::pair{"copper_heat_mW", powers.copper},
                                   {"lead_heat_mW", powers.leads},
                                   {"mechanical_mW", powers.mechanical},
                                   {"hinge_loss_mW", powers.hinges},
                                   {"friction_loss_mW", powers.friction},
                                   {"impact_loss_mW", powers.impacts},
                                   {"stored_mW", powers.stored},
                                   {"unbalanced_mW", powers.unbalanced}})
    rows.emplace_back(key, watts * 1e3);
  rows.insert(rows.end(), {{"coil_rms_current_A", heat.rms_current},
                           {"continuous_current_A", heat.taken.for_good},
                           {"time_to_limit_s", heat.taken.until},
                           {"still_air_continuous_current_A", heat.still_air.for_good},
                           {"still_air_time_to_limit_s", heat.still_air.until}});
  return rows;
}

text::Json to_json(const CrawlRows& rows) {
  text::Json out = text::Json::object({});
  for (const auto& [key, value] : rows) out.set(key, value);
  return out;
}

}  // namespace coilwright::formats
