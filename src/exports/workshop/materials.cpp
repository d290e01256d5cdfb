#include "exports/workshop/sheets.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <optional>
#include <sstream>

#include "coilwright/actuator/cost.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::exports {
namespace {

std::string magnet_text(const actuator::MagnetDesign& magnet) {
  const std::string size =
      fmt::format("cylinder, diameter {:.4g} mm, length {:.4g} mm, magnetised along its axis, remanence {:.4g} T",
                  2e3 * magnet.radius, 1e3 * magnet.length, magnet.remanence);
  if (magnet.grade == nullptr) return size + "; the design names no grade";
  return fmt::format("NdFeB {} {}", magnet.grade->name, size);
}

std::string silicone_text(const actuator::SiliconeDesign& silicone) {
  return fmt::format("two-part, {}, {:.5g} kg/m3 when cured, addition-curing", silicone.name(), silicone.density);
}

double wall_on(const BodyPlan& plan, actuator::ComponentKind kind) {
  for (const PlacedPart& part : plan.parts)
    if (part.component.kind == kind) return part.face_wall;
  return 0.0;
}

}  // namespace

std::vector<BillRow> bill_of_materials(const DesignSubject& subject, const ExportSettings& settings,
                                       const WindingSheet& winding, const Cast& cast) {
  const actuator::Cost cost = actuator::cost_of(subject.design, subject.assembly);
  const actuator::BodyDesign& body = subject.design.body;
  const std::optional<actuator::SiliconeDesign>& bottom = subject.design.bottom_silicone;
  const winding::Wire& wire = winding.wire;
  const auto in_grams = [&settings](double mass) {
    return fmt::format("{:.4g} g in the actuator, {:.4g} g with waste", 1e3 * mass,
                       1e3 * mass * (1.0 + settings.waste));
  };
  std::vector<BillRow> rows = {
      {.item = "coils, of magnet wire",
       .specification = fmt::format(
           "enamelled copper, {}, {}, enamel for {:.4g} degC or more",
           wire.awg ? fmt::format("{} ({:.4g} mm bare)", wire.name(), 1e3 * wire.bare_diameter) : wire.name() + " bare",
           wire.enamel_name(), subject.design.surroundings.coil_limit),
       .quantity = fmt::format("{:.4g} m for {} coil{}", winding.coils * winding.wire_with_leads, winding.coils,
                               winding.coils == 1 ? "" : "s"),
       .price = cost.coils},
      {.item = "magnets",
       .specification = magnet_text(subject.design.magnet),
       .quantity = fmt::format("{}", subject.assembly.magnets),
       .price = cost.magnets},
      {.item = "silicone and moulds",
       .specification = silicone_text(body) + (bottom ? ", for the body" : "") + "; plastic for the printed mould",
       .quantity = in_grams(body.density * (cast.silicone_volume - cast.bottom_volume)),
       .price = cost.silicone_and_moulds},
      {.item = "flexible wires",
       .specification = "silicone-insulated, from the leads to the driver",
       .quantity = fmt::format("{}", 2 * winding.coils),
       .price = cost.wires},
      {.item = "driver and supply",
       .specification = has_one_current(subject.design)
                            ? "H-bridge board and power supply, once for all actuators"
                            : "power supply and an H-bridge board for each coil, of which the price has one",
       .quantity = "1",
       .price = actuator::driver_and_supply_cost},
  };
  if (bottom)
    rows.insert(rows.begin() + 3, {.item = "silicone of the bottom layer",
                                   .specification = silicone_text(*bottom) + "; its price is within that of the body's",
                                   .quantity = in_grams(bottom->density * cast.bottom_volume),
                                   .price = 0.0});
  return rows;
}

std::string materials_csv(const std::vector<BillRow>& rows) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"item", "specification", "quantity", "price_USD"});
  for (const BillRow& row : rows) csv.row({row.item, row.specification, row.quantity, rounded(row.price)});
  return out.str();
}

Recipe recipe(const DesignSubject& subject, const ExportSettings& settings, const Cast& cast) {
  const actuator::BodyDesign& body = subject.design.body;
  const auto ratio_of = [](const actuator::SiliconeDesign& silicone) {
    return silicone.grade == nullptr ? 0.0 : silicone.grade->base_per_hardener;
  };
  const double ratio = settings.base_per_hardener > 0.0 ? settings.base_per_hardener : ratio_of(body);
  const auto batch = [&](std::string_view use, double in_actuator, double dip) {
    return Batch{.use = use,
                 .density = body.density,
                 .base_per_hardener = ratio,
                 .in_actuator = in_actuator,
                 .waste = settings.waste * in_actuator,
                 .dip = dip};
  };
  Recipe out{.segments = {},
             .batches = {batch("main body and first dip", cast.main_volume, cast.dip_volume),
                         batch("second dip", 0.0, cast.dip_volume),
                         batch("walls and bores and bond", cast.filling_volume, 0.0)},
             .coil_dip = wall_on(cast.plan, actuator::ComponentKind::coil),
             .magnet_dip = wall_on(cast.plan, actuator::ComponentKind::magnet)};
  for (std::size_t i = 0; i < subject.assembly.segments.size(); ++i)
    out.segments.push_back({.segment = static_cast<int>(i) + 1,
                            .kind = subject.design.layout[i].kind,
                            .volume = volume_of(subject.assembly.segments[i], subject.design),
                            .mass = subject.assembly.segments[i].silicone_mass});
  if (const auto& bottom = subject.design.bottom_silicone)
    out.batches.insert(out.batches.begin(), {.use = "bottom layer",
                                             .density = bottom->density,
                                             .base_per_hardener = ratio_of(*bottom),
                                             .in_actuator = cast.bottom_volume,
                                             .waste = settings.waste * cast.bottom_volume});
  return out;
}

std::string casting_csv(const Recipe& recipe) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"what", "in_actuator_cm3", "waste_cm3", "dip_cm3", "mixed_cm3", "mixed_g"});
  const auto cm3 = [](double volume) { return rounded(1e6 * volume); };
  for (const Batch& batch : recipe.batches)
    csv.row({batch.use, cm3(batch.in_actuator), cm3(batch.waste), cm3(batch.dip), cm3(batch.mixed()),
             rounded(1e3 * batch.density * batch.mixed())});
  for (const SegmentSilicone& segment : recipe.segments) {
    const std::string what = fmt::format("segment {} ({})", segment.segment,
                                         segment.kind == actuator::ComponentKind::coil ? "coil" : "magnet");
    csv.row({what, cm3(segment.volume), {}, {}, {}, {}});
  }
  return out.str();
}

double rounded(double value) {
  const std::string text = fmt::format("{:.6g}", value);
  double out = value;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

}  // namespace coilwright::exports
