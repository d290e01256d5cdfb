#include "coilwright/formats/data/measured_unit.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace coilwright::formats {
namespace {

using measurement::data::ChannelKind;

constexpr units::Unit as_it_is{.suffix = "", .dimension = ""};

units::Unit unit_named(std::string_view suffix) {
  for (const units::Unit& unit : units::all_units())
    if (unit.suffix == suffix) return unit;
  return as_it_is;
}

}  // namespace

std::string_view name_of(ChannelKind quantity) {
  switch (quantity) {
    case ChannelKind::bending_angle:
    case ChannelKind::joint_angle:
      return "angle";
    case ChannelKind::joint_rate:
      return "joint_rate";
    case ChannelKind::torque:
      return "torque";
    case ChannelKind::force:
      return "force";
    case ChannelKind::temperature:
      return "temperature";
  }
  return "";
}

units::Unit error_unit(ChannelKind quantity) {
  switch (quantity) {
    case ChannelKind::bending_angle:
    case ChannelKind::joint_angle:
      return unit_named("deg");
    case ChannelKind::joint_rate:
      return unit_named("deg_s");
    case ChannelKind::torque:
      return unit_named("Nmm");
    case ChannelKind::force:
      return unit_named("N");
    case ChannelKind::temperature:
      return unit_named("K");
  }
  return as_it_is;
}

units::Unit variable_unit(std::string_view variable) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> table = {
      {{"angle", "deg"}, {"rate", "deg_s"}, {"current", "A"}, {"time", "s"}, {"frequency", "Hz"}}};
  for (const auto& [name, suffix] : table)
    if (name == variable) return unit_named(suffix);
  return as_it_is;
}

std::string with_unit(std::string_view name, const units::Unit& unit) {
  return unit.suffix.empty() ? std::string(name) : fmt::format("{}_{}", name, unit.suffix);
}

}  // namespace coilwright::formats
