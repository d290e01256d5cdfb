#include <string>
#include <string_view>

#include "cli/search/list/listings.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/systems/crawl_quantities.hpp"
#include "coilwright/systems/driver_quantities.hpp"
#include "coilwright/systems/gripper/quantities.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using simulation::ResultQuantity;
using simulation::Settings;

std::string unit_of(const ResultQuantity& quantity) {
  if (!quantity.unit.empty()) return quantity.unit;
  const auto split = units::split_unit(quantity.name);
  return split ? std::string(split->unit.suffix) : std::string();
}

// What a range is to a variable, its absence is to a result: where it has no value.
void add(Listing& listing, const ResultQuantity& quantity, std::string_view source) {
  listing.rows.push_back({quantity.name, unit_of(quantity), std::string(source), quantity.meaning, quantity.absence});
}

}  // namespace

Listing quantity_listing() {
  Listing listing{.columns = {"key", "unit", "of", "meaning", "absent_where"}, .rows = {}};
  for (const ResultQuantity& each : simulation::standard_quantities()) add(listing, each, "evaluate");
  const auto no_grip = [](const Settings&) { return systems::gripper::GripperTask{}; };
  for (const ResultQuantity& each : systems::gripper::gripper_quantities(no_grip)) add(listing, each, "gripper");
  const auto no_crawl = [](const Settings&) { return systems::CrawlTask{}; };
  for (const ResultQuantity& each : systems::crawl_quantities(no_crawl)) add(listing, each, "crawler");
  const auto no_driver = [](const Settings&) { return systems::DriverTask{}; };
  for (const ResultQuantity& each : systems::driver_quantities(no_driver)) add(listing, each, "driver");
  return listing;
}

}  // namespace coilwright::cli
