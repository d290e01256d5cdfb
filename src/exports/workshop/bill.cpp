#include "exports/workshop/bill.hpp"

#include <fmt/format.h>

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

}  // namespace

std::vector<BillRow> bill_of_materials(const DesignSubject& subject, const ExportSettings& settings,
                                       const WindingSheet& winding, const Cast& cast) {
  const actuator::Cost cost = actuator::cost_of(subject.design, subject.assembly);
  const actuator::BodyDesign& body = subject.design.body;
  return {
      {.item = "coils, of magnet wire",
       .specification =
           fmt::format("enamelled copper, AWG {} ({:.4g} mm bare), single build, enamel for {:.4g} degC or more",
                       winding.wire_gauge, 1e3 * winding.bare_diameter, subject.design.surroundings.coil_limit),
       .quantity = fmt::format("{:.4g} m for {} coil{}", winding.coils * winding.wire_with_leads, winding.coils,
                               winding.coils == 1 ? "" : "s"),
       .price = cost.coils},
      {.item = "magnets",
       .specification = magnet_text(subject.design.magnet),
       .quantity = fmt::format("{}", subject.assembly.magnets),
       .price = cost.magnets},
      {.item = "silicone and moulds",
       .specification =
           fmt::format("two-part, Shore {:.4g}A, {:.5g} kg/m3 when cured, addition-curing; plastic for the "
                       "printed mould",
                       body.shore_hardness, body.density),
       .quantity =
           fmt::format("{:.4g} g in the actuator, {:.4g} g with waste", 1e3 * body.density * cast.silicone_volume,
                       1e3 * body.density * cast.silicone_volume * (1.0 + settings.waste)),
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
}

std::string materials_csv(const std::vector<BillRow>& rows) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"item", "specification", "quantity", "price_USD"});
  for (const BillRow& row : rows) csv.row({row.item, row.specification, row.quantity, rounded(row.price)});
  return out.str();
}

}  // namespace coilwright::exports
