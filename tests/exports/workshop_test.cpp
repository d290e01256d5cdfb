#include "coilwright/exports/kinds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "coilwright/actuator/cost.hpp"
#include "coilwright/winding/copper.hpp"
#include "error_text.hpp"
#include "exports/finger.hpp"

namespace coilwright::exports {
namespace {

using actuator::Component;
using actuator::ComponentKind;
using actuator::Design;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// The sheets have numbers of six digits; three of them in a product or a sum.
constexpr double six_digits = 1.5e-5;

// Rows of a CSV text without quotes, header first.
std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && line.back() == '\r') line.pop_back();
    std::vector<std::string> cells;
    std::istringstream cell_stream(line + ",");
    for (std::string cell; std::getline(cell_stream, cell, ',');) cells.push_back(cell);
    rows.push_back(cells);
  }
  return rows;
}

std::map<std::string, double> quantities_of(const std::string& winding_csv) {
  std::map<std::string, double> out;
  for (const auto& row : rows_of(winding_csv))
    if (row.size() == 2 && row[0] != "quantity") out[row[0]] = std::stod(row[1]);
  return out;
}

Design general_design() {
  Design design;
  design.coil = {.inner_radius = 2.3e-3, .turns_radial = 11, .turns_axial = 23, .wire_gauge = 30};
  design.magnet.radius = 7.1e-3;
  design.magnet.length = 5.3e-3;
  design.body.gap = 1.2e-3;
  return design;
}

// Table I and the errata: 15 layers of 30 turns, 17.67 m of 0.32 mm, 3.76 ohm, 12.7 g of copper.
TEST(WindingSheet, IsThatOfThePrototype) {
  Design design;
  const auto winding = quantities_of(text_of(workshop(subject_of(design), {.lead_length = 0.2}), "winding.csv"));
  EXPECT_EQ(winding.at("coils"), 2);
  EXPECT_EQ(winding.at("turns_in_layer"), 30);
  EXPECT_EQ(winding.at("layers"), 15);
  EXPECT_EQ(winding.at("core_diameter_mm"), 6.0);
  EXPECT_NEAR(winding.at("flange_distance_mm"), 12.0, 0.05);  // the prototype's packing, to its digits
  EXPECT_NEAR(winding.at("outer_diameter_mm"), 19.0, 0.05);
  EXPECT_NEAR(winding.at("wire_of_turns_m"), 17.67, 0.005);
  EXPECT_NEAR(winding.at("wire_with_leads_m"), 17.67 + 0.4, 0.005);
  EXPECT_NEAR(winding.at("coil_resistance_Ohm"), 3.76, 0.005);
  EXPECT_NEAR(winding.at("copper_mass_g"), 12.7, 0.15);
}

// 0.25 mm of grade 1 has 0.281 mm over the enamel and a copper of 0.246 to 0.254 mm (IEC 60317-0-1).
TEST(WindingSheet, OfAWireByItsDiameterNamesNoGauge) {
  Design design;
  design.coil.wire_diameter = 0.25e-3;
  const auto files = workshop(subject_of(design), {});
  const auto winding = quantities_of(text_of(files, "winding.csv"));
  EXPECT_FALSE(winding.contains("wire_gauge_AWG"));
  EXPECT_EQ(winding.at("bare_diameter_mm"), 0.25);
  EXPECT_EQ(winding.at("least_bare_diameter_mm"), 0.246);
  EXPECT_EQ(winding.at("largest_bare_diameter_mm"), 0.254);
  EXPECT_EQ(winding.at("insulated_diameter_mm"), 0.281);
  const double section = 0.25 * std::numbers::pi * 0.25e-3 * 0.25e-3;
  const double resistance = winding::copper_resistivity * winding.at("wire_of_turns_m") / section;
  EXPECT_NEAR(winding.at("coil_resistance_Ohm"), resistance, six_digits * resistance);
  EXPECT_NEAR(winding.at("copper_mass_g"), 1e3 * winding::copper_density * section * winding.at("wire_of_turns_m"),
              six_digits * winding.at("copper_mass_g"));
  const std::string page = text_of(files, "workshop.html");
  EXPECT_NE(page.find("0.25 mm, grade 1"), std::string::npos);
  EXPECT_NE(page.find("(IEC 60317-0-1)"), std::string::npos);
  EXPECT_EQ(page.find("AWG"), std::string::npos);
  EXPECT_NE(text_of(files, "materials.csv").find("enamelled copper, 0.25 mm bare, grade 1"), std::string::npos);
}

TEST(Casting, PoursABottomLayerOfItsOwnSiliconeFirst) {
  Design design;
  const auto plain = rows_of(text_of(workshop(subject_of(design), {}), "casting.csv"));
  design.body.make_of(&mechanics::silicone_grades()[2]);  // Ecoflex 00-30
  design.bottom_silicone = design.body;
  design.bottom_silicone->make_of(&mechanics::silicone_grades()[6]);  // Dragon Skin 30
  const DesignSubject subject = subject_of(design);
  const auto files = workshop(subject, {});
  const auto rows = rows_of(text_of(files, "casting.csv"));
  ASSERT_GT(rows.size(), plain.size());
  EXPECT_EQ(rows[1][0], "bottom layer");
  const auto& size = subject.assembly.dimensions;
  const double bottom = 1e6 * size.width * design.body.bottom_layer * size.total_length;
  EXPECT_NEAR(std::stod(rows[1][1]), bottom, six_digits * bottom);
  // Together as much as of one silicone.
  EXPECT_NEAR(std::stod(rows[1][1]) + std::stod(rows[2][1]), std::stod(plain[1][1]), 1e-4 * std::stod(plain[1][1]));
  EXPECT_NEAR(std::stod(rows[1][5]), 1.08 * std::stod(rows[1][4]), 1e-4 * std::stod(rows[1][5]));
  EXPECT_NEAR(std::stod(rows[2][5]), 1.07 * std::stod(rows[2][4]), 1e-4 * std::stod(rows[2][5]));
  const std::string bill = text_of(files, "materials.csv");
  EXPECT_NE(bill.find("two-part, Ecoflex 00-30, 1070 kg/m3"), std::string::npos);
  EXPECT_NE(bill.find("two-part, Dragon Skin 30, 1080 kg/m3"), std::string::npos);
  EXPECT_NE(text_of(files, "workshop.html").find("Part A to part B of the body as 1 to 1 by mass"), std::string::npos);
}

// The circles of all layers, one by one, against the mean radius by which the winding computes.
TEST(WindingSheet, AddsUpLayerByLayer) {
  const DesignSubject subject = subject_of(general_design());
  const auto files = workshop(subject, {});
  const auto layers = rows_of(text_of(files, "layers.csv"));
  const auto winding = quantities_of(text_of(files, "winding.csv"));
  ASSERT_EQ(layers.size(), 12);
  double wire = 0.0;
  for (std::size_t i = 1; i < layers.size(); ++i) {
    const double centre = std::stod(layers[i][1]) - winding.at("insulated_diameter_mm");
    wire += std::numbers::pi * centre * 1e-3 * 23;
    EXPECT_NEAR(std::stod(layers[i][3]), wire, six_digits * wire) << i;
  }
  const double bare = 0.127e-3 * std::pow(92.0, (36.0 - 30.0) / 39.0);  // ASTM B258
  const double section = 0.25 * std::numbers::pi * bare * bare;
  EXPECT_NEAR(winding.at("wire_of_turns_m"), wire, six_digits * wire);
  EXPECT_NEAR(subject.assembly.coil.wire_length, wire, six_digits * wire);
  const double resistance = winding::copper_resistivity * wire / section;
  EXPECT_NEAR(winding.at("coil_resistance_Ohm"), resistance, six_digits * resistance);
  EXPECT_NEAR(std::stod(layers.back()[4]), resistance, six_digits * resistance);
}

TEST(WindingSheet, ShowsWhatAMeterShowsWithTheLeads) {
  const auto without =
      quantities_of(text_of(workshop(subject_of(general_design()), {.lead_length = 0}), "winding.csv"));
  const auto with = quantities_of(text_of(workshop(subject_of(general_design()), {.lead_length = 0.5}), "winding.csv"));
  EXPECT_EQ(without.at("meter_reading_20_degC_Ohm"), without.at("coil_resistance_Ohm"));
  // AWG 30: 103.7 ohm per 1000 ft of 0.100 inch, and both leads are 1 m. The gauge is 0.3 % thicker than that.
  EXPECT_NEAR(with.at("meter_reading_20_degC_Ohm") - without.at("meter_reading_20_degC_Ohm"), 103.7 / 304.8,
              0.005 * 103.7 / 304.8);
  // The same table's least and largest resistance, 101.7 and 105.8.
  EXPECT_NEAR(with.at("largest_reading_Ohm") / with.at("least_reading_Ohm"), 105.8 / 101.7, 1e-3);
  EXPECT_LT(with.at("least_reading_Ohm"), with.at("meter_reading_20_degC_Ohm"));
  EXPECT_GT(with.at("largest_reading_Ohm"), with.at("meter_reading_20_degC_Ohm"));
}

TEST(BillOfMaterials, AddsUpToTheCostOfTheActuator) {
  Design design = general_design();
  design.layout = actuator::layout_of(actuator::Configuration::C);
  const DesignSubject subject = subject_of(design);
  double sum = 0.0;
  int rows = 0;
  for (const ExportedFile& file : workshop(subject, {})) {
    if (file.name != "materials.csv") continue;
    std::istringstream lines(file.text);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && !line.empty()) {
      sum += std::stod(line.substr(line.rfind(',') + 1));
      ++rows;
    }
  }
  EXPECT_EQ(rows, 5);
  EXPECT_NEAR(sum, actuator::cost_of(subject.design, subject.assembly).total() + actuator::driver_and_supply_cost,
              six_digits * sum);
}

// Box less coils and magnet, by hand: 61 x 22 x 24 mm, two coils of 19 mm and 6 mm by 12 mm, a magnet of 20 mm by 6 mm.
TEST(Recipe, HasTheSiliconeOfThePrototype) {
  Design design;
  const DesignSubject subject = subject_of(design);
  const auto casting = rows_of(text_of(workshop(subject, {.waste = 0.5}), "casting.csv"));
  const double pi = std::numbers::pi;
  const double by_hand = (61.0 * 22.0 * 24.0 - 2 * pi * (9.5 * 9.5 - 3.0 * 3.0) * 12.0 - pi * 100.0 * 6.0) * 1e-3;
  double batches = 0.0;
  double segments = 0.0;
  for (const auto& row : casting) {
    if (row[0].starts_with("segment")) {
      segments += std::stod(row[1]);
    } else if (row[0] != "what") {
      batches += std::stod(row[1]);
      EXPECT_NEAR(std::stod(row[2]), 0.5 * std::stod(row[1]), six_digits * batches) << row[0];
    }
  }
  // The prototype's packing gives 9.5 and 12 mm to a hundredth: 0.1 % of the volume.
  EXPECT_NEAR(batches, by_hand, 1e-3 * by_hand);
  EXPECT_NEAR(segments, batches, six_digits * batches);
}

// Figures of the prototype: the straight finger's coils bear 1.067 A and its magnet 0.96 A (actuator/heat.hpp).
TEST(AssemblyOrder, SaysWhichCurrentItBearsAndWasSizedFor) {
  const auto in_use = [](const DesignSubject& subject) {
    const std::string page = text_of(workshop(subject, {}), "workshop.html");
    const std::size_t begin = page.find("<li>In use.");
    return page.substr(begin, page.find("</li>", begin) - begin);
  };
  DesignSubject subject = subject_of(Design{});
  const std::string text = in_use(subject);
  const std::string before = "the actuator holds ";
  EXPECT_NEAR(std::stod(text.substr(text.find(before) + before.size())), 0.96, 0.005) << text;
  EXPECT_THAT(text, AllOf(HasSubstr("A in every coil for good; then the hottest magnet is at its limit"),
                          Not(HasSubstr("It was sized for"))));
  subject.operating_point = actuator::OperatingPoint{.current = 0.8, .duty = 0.25};
  EXPECT_THAT(in_use(subject), HasSubstr("It was sized for 0.8 A during 0.25 of the time."));
}

// Directions as the table tells them, by dipoles: a current that runs clockwise for who looks from the tip has its
// moment towards the base, and two moments in a row attract each other where they point the same way.
TEST(AssemblyOrder, HasTheSensesByWhichTheModelMoves) {
  constexpr Component coil{.kind = ComponentKind::coil};
  constexpr Component coil_turned{.kind = ComponentKind::coil, .polarity = -1};
  constexpr Component magnet{.kind = ComponentKind::magnet};
  constexpr Component magnet_turned{.kind = ComponentKind::magnet, .polarity = -1};
  const std::vector<actuator::Layout> layouts = {{coil, magnet, coil},
                                                 {coil, magnet, coil_turned},
                                                 {coil_turned, magnet, coil},
                                                 {coil, magnet_turned, coil},
                                                 {coil, magnet, coil, magnet_turned, coil_turned},
                                                 {magnet_turned, coil_turned, coil, magnet}};
  for (const actuator::Layout& layout : layouts) {
    Design design = general_design();
    design.layout = layout;
    const DesignSubject subject = subject_of(design);
    const auto rows = rows_of(text_of(workshop(subject, {}), "assembly.csv"));
    ASSERT_EQ(rows.size(), layout.size() + 1);
    const auto moment = [&](std::size_t part) {
      const std::vector<std::string>& row = rows[part + 1];
      if (row[1] == "magnet") return row[3] == "tip" ? 1.0 : -1.0;
      EXPECT_EQ(row[5] == "start", row[4] == "clockwise");  // all are wound alike, clockwise from the start
      return row[4] == "clockwise" ? -1.0 : 1.0;
    };
    const actuator::Model& model = subject.assembly.model;
    const mechanics::JointVector straight = mechanics::JointVector::Zero(model.joints());
    // Half the difference of both signs of the current: what the magnets do to each other drops out.
    const mechanics::JointVector opening = 0.5 * (model.magnetic_torques(straight, model.all_coils(1.0)) -
                                                  model.magnetic_torques(straight, model.all_coils(-1.0)));
    for (std::size_t joint = 0; joint + 1 < layout.size(); ++joint) {
      if (layout[joint].kind == layout[joint + 1].kind) continue;
      const bool repel = moment(joint) * moment(joint + 1) < 0.0;
      EXPECT_EQ(repel, opening[static_cast<Eigen::Index>(joint)] > 0.0) << joint;
    }
  }
}

TEST(AssemblyOrder, LeadsTheStartOutWhereNoMagnetIs) {
  const auto faces = [](actuator::Configuration configuration) {
    Design design;
    design.layout = actuator::layout_of(configuration);
    std::vector<std::string> out;
    for (const auto& row : rows_of(text_of(workshop(subject_of(design), {}), "assembly.csv")))
      if (row[1] == "coil") out.push_back(row[6]);
    return out;
  };
  EXPECT_THAT(faces(actuator::Configuration::B), testing::ElementsAre("base", "tip"));
  EXPECT_THAT(faces(actuator::Configuration::C), testing::ElementsAre("base", "neither", "tip"));
  EXPECT_THAT(faces(actuator::Configuration::D), testing::ElementsAre("base", "tip", "base", "tip"));
}

TEST(Workshop, IsOnePageWithoutAnythingFromOutside) {
  const std::string page = text_of(workshop(subject_of(Design{}, R"(a <b> & "c" 'd')"), {}), "workshop.html");
  EXPECT_THAT(page, testing::HasSubstr("a &lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;"));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("<b>")));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("<script")));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("href")));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("src=")));
}

TEST(Workshop, WarnsOfACellThatDrivesMoreThanTheWireBears) {
  Design design;
  design.coil = {.inner_radius = 3e-3, .turns_radial = 2, .turns_axial = 5, .wire_gauge = 28};
  EXPECT_THAT(text_of(workshop(subject_of(design), {}), "workshop.html"), testing::HasSubstr("put a resistor of"));
  EXPECT_THAT(text_of(workshop(subject_of(Design{}), {}), "workshop.html"),
              testing::Not(testing::HasSubstr("put a resistor of")));
}

TEST(Workshop, RefusesACalibratedAxisThatNoBodyHas) {
  Design design;
  design.calibration.axis_offset = 10.5 / 11.5;
  EXPECT_EQ(error_text([&] { static_cast<void>(workshop(subject_of(design), {})); }),
            "the measured axis lies 11.75 mm above the underside, where the largest part (radius 10 mm) cuts into the "
            "bottom layer (2.5 mm): it cannot be cast so");
  design.calibration.axis_offset = 13.5 / 11.5;
  EXPECT_EQ(
      error_text([&] { static_cast<void>(workshop(subject_of(design), {})); }),
      "the measured axis lies 14.75 mm above the underside, where the largest part (radius 10 mm) stands out of a "
      "body 24 mm high: it cannot be cast so");
}

}  // namespace
}  // namespace coilwright::exports
