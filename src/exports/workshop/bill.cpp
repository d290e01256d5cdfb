#include "exports/workshop/bill.hpp"

#include <fmt/format.h>

#include <optional>
#include <sstream>

#include "coilwright/actuator/cost.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "exports/workshop/rounded.hpp"

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

}  // namespace coilwright::exports
