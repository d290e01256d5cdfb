#include "exports/workshop/sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace coilwright::exports {
namespace {

using text::html_table;

using Rows = std::vector<std::vector<std::string>>;

std::string mm(double length) {
  return fmt::format("{:.4g} mm", 1e3 * length);
}

std::string ohm(double resistance) {
  return fmt::format("{:#.4g} Ω", resistance);
}

std::string cm3(double volume) {
  return fmt::format("{:.1f}", 1e6 * volume);
}

std::string_view kind_name(actuator::ComponentKind kind) {
  return kind == actuator::ComponentKind::magnet ? "magnet" : "coil";
}

std::string wire_and_bobbin(const WindingSheet& sheet) {
  const Rows rows = {
      {"coils to wind", fmt::format("{}", sheet.coils)},
      {"wire", fmt::format("{}, {}", sheet.wire.name(), sheet.wire.enamel_name())},
      {"bare diameter", mm(sheet.wire.bare_diameter)},
      {"bare diameter as sold", fmt::format("{:.4g} to {}", 1e3 * sheet.wire.least_bare, mm(sheet.wire.largest_bare))},
      {"diameter over the enamel, at most", mm(sheet.wire.insulated_diameter)},
      {"bobbin: diameter of the core", mm(sheet.core_diameter)},
      {"bobbin: distance of the flanges", mm(sheet.flange_distance)},
      {"bobbin: diameter of the flanges, at least", mm(sheet.flange_diameter)},
      {"turns in a layer", fmt::format("{}", sheet.turns_in_layer)},
      {"layers", fmt::format("{}", sheet.layers)},
      {"turns", fmt::format("{}", sheet.layers * sheet.turns_in_layer)},
      {"from turn to turn", mm(sheet.turn_pitch)},
      {"from layer to layer", mm(sheet.layer_pitch)},
      {"diameter of the finished coil", mm(sheet.outer_diameter)},
      {"wire of the turns", fmt::format("{:.4g} m", sheet.wire_length)},
      {"each of the two leads", mm(sheet.lead_length)},
      {"wire of one coil with its leads", fmt::format("{:.4g} m", sheet.wire_with_leads)},
      {"copper of the turns", fmt::format("{:.4g} g", 1e3 * sheet.copper_mass)},
      {"inductance", fmt::format("{:.3g} mH", 1e3 * sheet.inductance)},
      {"current limit of the wire", fmt::format("{:.3g} A", sheet.current_limit)},
  };
  return html_table({"quantity", "value"}, rows);
}

std::string readings(const WindingSheet& sheet) {
  Rows rows;
  for (const double temperature : {15.0, 20.0, 25.0, 30.0}) {
    const MeterReading reading = meter_reading(sheet, temperature);
    rows.push_back(
        {fmt::format("{:.0f} °C", temperature), ohm(reading.expected), ohm(reading.least), ohm(reading.largest)});
  }
  return html_table({"temperature of the coil", "a meter shows", "at least", "at most"}, rows);
}

std::string layers(const WindingSheet& sheet) {
  Rows rows;
  for (const LayerRow& row : sheet.rows)
    rows.push_back({fmt::format("{}", row.layer), fmt::format("{:.2f}", 1e3 * row.diameter),
                    fmt::format("{}", row.layer * sheet.turns_in_layer), fmt::format("{:.2f}", row.wire_so_far),
                    fmt::format("{:.3f}", row.resistance)});
  return html_table({"layer", "diameter, mm", "turns so far", "wire so far, m", "resistance so far, Ω"}, rows);
}

// An ordered list of escaped texts.
std::string html_list(const std::vector<std::string>& items) {
  std::string out = "<ol>\n";
  for (const std::string& item : items) out += fmt::format("<li>{}</li>\n", text::escaped(item));
  return out + "</ol>\n";
}

}  // namespace

std::string winding_section(const WindingSheet& sheet) {
  const double last_layer = sheet.layers > 1
                                ? sheet.rows.back().resistance - sheet.rows[sheet.rows.size() - 2].resistance
                                : sheet.rows.back().resistance;
  std::string text = "<section>\n<h2>Winding sheet</h2>\n" + wire_and_bobbin(sheet);
  text += fmt::format(
      "<p>The bobbin is a tool: the finished coil leaves it, and its bore is filled with silicone. Of the layers, "
      "{}.</p>\n"
      "<h2>Resistance, to check with a meter</h2>\n{}",
      sheet.staggered ? "each lies in the grooves of the one below" : "each lies on the one below without sinking in",
      readings(sheet));
  text += fmt::format(
      "<p>Between the ends of the leads, both of them included ({}). The limits are those of the wire's diameter as it "
      "is sold ({}). A diameter 0.1 mm larger than the sheet's adds {}. A layer missing at the outside shows as {} "
      "less, one turn of it as {}.</p>\n",
      ohm(sheet.lead_resistance), sheet.wire.awg ? "NEMA MW 1000" : "IEC 60317-0-1",
      ohm(reading_of_wider_coil(sheet, 0.1e-3)), ohm(last_layer), ohm(last_layer / sheet.turns_in_layer));
  if (sheet.resistance_factor != 1.0)
    text += fmt::format(
        "<p>The design has a measured resistance of {} a coil, {:.3g} times what its copper gives; the sheet follows "
        "the measured one.</p>\n",
        ohm(sheet.coil_resistance), sheet.resistance_factor);
  return text + "<h2>Layer by layer</h2>\n" + layers(sheet) + "</section>\n";
}

std::string bill_section(const std::vector<BillRow>& rows) {
  Rows cells;
  double actuator = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i + 1 == rows.size()) cells.push_back({"sum of one actuator", "", "", fmt::format("{:.2f}", actuator)});
    cells.push_back({rows[i].item, rows[i].specification, rows[i].quantity, fmt::format("{:.2f}", rows[i].price)});
    actuator += rows[i].price;
  }
  return "<section class=\"page\">\n<h2>Bill of materials</h2>\n" +
         html_table({"item", "specification", "quantity", "price, US$"}, cells) +
         "<p>Prices are those of the source paper's Table III, the wire's scaled with the copper, the magnets' with "
         "their volume and grade; that of silicone and moulds is not scaled.</p>\n</section>\n";
}

std::string recipe_section(const Recipe& recipe) {
  Rows batches;
  const bool ratios =
      std::ranges::any_of(recipe.batches, [](const Batch& each) { return each.base_per_hardener > 0.0; });
  for (const Batch& batch : recipe.batches) {
    const double grams = 1e3 * batch.density * batch.mixed();
    std::vector<std::string> row = {std::string(batch.use), cm3(batch.in_actuator), cm3(batch.waste),
                                    cm3(batch.dip),         cm3(batch.mixed()),     fmt::format("{:.1f}", grams)};
    if (ratios) {
      const bool known = batch.base_per_hardener > 0.0;
      const double hardener = grams / (1.0 + batch.base_per_hardener);
      row.push_back(known ? fmt::format("{:.2f}", grams - hardener) : "-");
      row.push_back(known ? fmt::format("{:.2f}", hardener) : "-");
    }
    batches.push_back(std::move(row));
  }
  std::vector<std::string> header = {
      "batch", "in the actuator, cm³", "waste, cm³", "in the dipping cup, cm³", "to mix, cm³", "to mix, g"};
  if (ratios) header.insert(header.end(), {"part A, g", "part B, g"});
  Rows segments;
  double sum = 0.0;
  double mass = 0.0;
  for (const SegmentSilicone& segment : recipe.segments) {
    sum += segment.volume;
    mass += segment.mass;
    segments.push_back({fmt::format("segment {} ({})", segment.segment, kind_name(segment.kind)), cm3(segment.volume),
                        fmt::format("{:.1f}", 1e3 * segment.mass)});
  }
  segments.push_back({"actuator", cm3(sum), fmt::format("{:.1f}", 1e3 * mass)});
  std::string text = "<section>\n<h2>Casting</h2>\n" + html_table(header, batches);
  text += recipe.batches.back().base_per_hardener > 0.0
              ? fmt::format("<p>Part A to part B of the body as {:.4g} to 1 by mass.</p>\n",
                            recipe.batches.back().base_per_hardener)
              : "<p>The masses of part A and part B follow from the mixing ratio on the silicone's data sheet "
                "(--base-per-hardener gives them here).</p>\n";
  text +=
      "<p>The dipping cup must be deep enough for the largest part; what stays in it is not used up. The walls of the "
      "parts come from the dips, so the last batch has that much to spare.</p>\n";
  return text + html_table({"where it ends", "silicone, cm³", "silicone, g"}, segments) + "</section>\n";
}

std::string assembly_section(const AssemblyOrder& order, std::string_view figure) {
  Rows parts;
  for (const PartRow& row : order.parts)
    parts.push_back({fmt::format("{}", row.number), std::string(kind_name(row.kind)),
                     fmt::format("{:.2f}", 1e3 * row.centre), std::string(row.north_towards), std::string(row.current),
                     std::string(row.positive_lead), std::string(row.start_face)});
  Rows joints;
  for (const JointRow& row : order.joints)
    joints.push_back({fmt::format("{}", row.number), fmt::format("{:.2f}", 1e3 * row.place),
                      fmt::format("{:.2f}", 1e3 * row.gap), std::string(row.effect)});
  return fmt::format("<section class=\"page\">\n<h2>Parts, from the base to the tip</h2>\n{}", figure) +
         html_table({"part", "kind", "centre from the rear end, mm", "north pole towards",
                     "positive current, seen from the tip", "positive lead", "start over the face towards"},
                    parts) +
         "<p>The poles of a coil are those at a positive current. Start: the end of the wire at the bore.</p>\n"
         "<h2>Joints, from the base to the tip</h2>\n" +
         html_table({"joint", "slit from the rear end, mm", "silicone between the parts, mm", "a positive current"},
                    joints) +
         "<h2>Order of assembly</h2>\n" + html_list(order.steps) + "<h2>Checks</h2>\n" + html_list(order.checks) +
         "</section>\n";
}

}  // namespace coilwright::exports
