// What a study becomes. What is refused, and how, is in tests/cli/study_input_test.py, text by text.
#include "coilwright/formats/study/study_file.hpp"

#include "coilwright/sizing/study/design_problem.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "temporary_folder.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using namespace sizing;

const std::string text = R"({
  "format": "study/1", "name": "all kinds", "description": "of variables", "actuator": "sub/finger.json",
  "operating_point": {"share_of_current_limit": 0.8, "duty": 0.3, "grasp_opening_deg": 30, "grasp_height_mm": 18},
  "variables": {
    "configuration": {"values": ["D", "A"]},
    "turns_radial": {"lower": 5, "upper": 17, "step": 3},
    "gap_mm": {"lower": 0.7, "upper": 1.6},
    "bottom_layer_mm": {"lower": 2, "upper": 3, "step": 0.25},
    "wire_gauge_AWG": {"values": [26, 29]}
  },
  "objectives": [{"maximise": "grasp_force_N"}, {"minimise": "mass_g"}],
  "constraints": [{"quantity": "mass_g", "at_most": 66.5}, {"quantity": "damping_ratio", "at_least": 0.04}],
  "search": {"algorithm": "cobyla", "max_evaluations": 321, "seed": 9007199254740992}
})";

class StudyFile : public ::testing::Test {
 protected:
  StudyFile() {
    std::filesystem::create_directory(folder_.path() / "sub");
    std::ofstream(folder_.path() / "sub/finger.json")
        << R"({"format": "actuator/1", "configuration": "B", "coil": {"turns_axial": 23}})";
  }

  Study parse(const std::string& study) const { return parse_study(study, (folder_.path() / "s.json").string()); }

  coilwright::testing::TemporaryFolder folder_;
};

TEST_F(StudyFile, IsReadWithTheActuatorBesideIt) {
  const Study study = parse(text);
  EXPECT_EQ(study.name, "all kinds");
  EXPECT_EQ(study.base.coil.turns_axial, 23);
  EXPECT_EQ(std::get<ShareOfLimit>(study.current).share, 0.8);
  EXPECT_EQ(study.operating.duty, 0.3);
  EXPECT_DOUBLE_EQ(study.operating.grasp.opening, std::numbers::pi / 6.0);
  EXPECT_DOUBLE_EQ(study.operating.grasp.height.value(), 18e-3);
  EXPECT_EQ(study.search.algorithm, Algorithm::cobyla);
  EXPECT_EQ(study.search.max_evaluations, 321u);
  EXPECT_EQ(study.search.seed, 9007199254740992u);
}

TEST_F(StudyFile, TakesAmericanSpellingOfTheSense) {
  std::string american = text;
  for (const auto* word : {"maximise", "minimise"}) {
    const std::size_t at = american.find(word);
    ASSERT_NE(at, std::string::npos);
    american[at + 6] = 'z';
  }
  const Study study = parse(american);
  ASSERT_EQ(study.objectives.size(), 2u);
  EXPECT_EQ(study.objectives[0].sense, Sense::maximise);
  EXPECT_EQ(study.objectives[1].sense, Sense::minimise);
}

TEST_F(StudyFile, KeepsItsVariablesInTheOrderWritten) {
  const Study study = parse(text);
  ASSERT_EQ(study.variables.size(), 5u);
  const auto& rows = std::get<LayoutVariable>(study.variables[0]);
  EXPECT_EQ(rows.name, "configuration");
  ASSERT_EQ(rows.values.size(), 2u);
  EXPECT_EQ(rows.values[0].name, "D");
  EXPECT_EQ(rows.values[1].layout, actuator::layout_of(actuator::Configuration::A));
  const auto& turns = std::get<Interval>(std::get<ParameterVariable>(study.variables[1]).range);
  EXPECT_EQ(turns.upper, 17.0);
  EXPECT_EQ(turns.step, 3.0);
  EXPECT_EQ(name_of(study.variables[2]), "gap_mm");
  EXPECT_EQ(std::get<Interval>(std::get<ParameterVariable>(study.variables[2]).range).step, 0.0);
  EXPECT_EQ(std::get<Choice>(std::get<ParameterVariable>(study.variables[4]).range).values, (std::vector{26.0, 29.0}));
}

TEST_F(StudyFile, NamesItsObjectivesAndLimits) {
  const Study study = parse(text);
  ASSERT_EQ(study.objectives.size(), 2u);
  EXPECT_EQ(study.objectives[1].quantity.name, "mass_g");
  EXPECT_EQ(study.objectives[1].sense, Sense::minimise);
  ASSERT_EQ(study.limits.size(), 2u);
  EXPECT_EQ(name_of(study.limits[0]), "mass_g <= 66.5");
  EXPECT_EQ(name_of(study.limits[1]), "damping_ratio >= 0.04");
}

TEST_F(StudyFile, NamesQuantitiesOfTheTableItIsGiven) {
  const simulation::QuantityTable table =
      simulation::standard_quantities().with({.name = "aspect_ratio",
                                              .meaning = "width divided by height of the cross-section",
                                              .scale = 1.0,
                                              .value = [](const simulation::DesignView& d) {
                                                return d.assembly.dimensions.width / d.assembly.dimensions.height;
                                              }});
  std::string own = text;
  own.replace(own.find("damping_ratio"), std::string_view("damping_ratio").size(), "aspect_ratio");
  const Study study = parse_study(own, (folder_.path() / "s.json").string(), {.quantities = table});
  EXPECT_EQ(study.limits[1].quantity.meaning, "width divided by height of the cross-section");
  EXPECT_EQ(study.quantities.size(), table.size());
  EXPECT_THROW((void)parse(own), text::InputError);  // the default has no such row
}

TEST_F(StudyFile, MayVaryAMaterialByItsName) {
  const auto study = [this](const std::string& values) {
    return parse(R"({"format": "study/1", "name": "grades", "actuator": "sub/finger.json",
      "variables": {"magnet_grade": {"values": )" +
                 values + R"(}, "magnet_length_mm": {"values": [4, 6]}},
      "operating_point": {"current_A": 1}, "objectives": [{"maximise": "stroke_deg"}]})");
  };
  const Study grades = study(R"(["N52", "N42SH", "none"])");
  EXPECT_EQ(search_variable(grades.variables[0]).kind, VariableKind::categorical);
  EXPECT_EQ(std::get<std::string_view>(value_at(grades.variables[0], 1.0)), "N42SH");
  const DesignProblem problem(grades);
  const actuator::Design design = problem.design_at(std::vector{1.0, 0.0});
  EXPECT_EQ(design.magnet.grade, magnetics::find_magnet_grade("N42SH"));
  EXPECT_EQ(design.magnet.remanence, 1.315);  // the grade's own, whatever the file says
  EXPECT_EQ(problem.design_at(std::vector{2.0, 0.0}).magnet.grade, nullptr);
  EXPECT_EQ(problem.point_count(), 6u);
  const auto message = [&](const std::string& values) { return text::testing::error_of([&] { (void)study(values); }); };
  EXPECT_NE(message(R"(["N42 SH"])").find(R"(/variables/magnet_grade/values/0: must be one of "none", "N35")"),
            std::string::npos);
  EXPECT_NE(message(R"(["N42 SH"])").find(R"(did you mean "N42SH"?)"), std::string::npos);
  EXPECT_NE(message(R"(["N42", "N42"])").find("/variables/magnet_grade/values/1: must not be there twice"),
            std::string::npos);
}

TEST_F(StudyFile, MayVaryTheRowOfPartsAndItsPolarity) {
  const auto study = [this](const std::string& variables) {
    return parse(R"({"format": "study/1", "name": "rows", "actuator": "sub/finger.json", "variables": {)" + variables +
                 R"(}, "operating_point": {"current_A": 1}, "objectives": [{"maximise": "stroke_deg"}]})");
  };
  const Study rows = study(
      R"("layout": {"values": ["C", ["coil", "magnet"], {"layout": ["coil", "magnet", "coil"], "polarity": [1, -1, 1]}]})");
  EXPECT_EQ(search_variable(rows.variables[0]).kind, VariableKind::categorical);
  EXPECT_EQ(std::get<std::string_view>(value_at(rows.variables[0], 0.0)), "C");
  EXPECT_EQ(std::get<std::string_view>(value_at(rows.variables[0], 1.0)), "coil magnet");
  EXPECT_EQ(std::get<std::string_view>(value_at(rows.variables[0], 2.0)), "coil -magnet coil");
  EXPECT_EQ(DesignProblem(rows).design_at(std::vector{2.0}).layout[1].polarity, -1);
  const Study senses = study(R"("polarity": {"values": [[1, 1, 1], [1, -1, 1]]})");
  EXPECT_EQ(name_of(senses.variables[0]), "polarity");
  EXPECT_EQ(DesignProblem(senses).problem().starts.at(0), std::vector{0.0});  // the actuator's own
  EXPECT_EQ(DesignProblem(senses).design_at(std::vector{1.0}).layout[1].polarity, -1);

  const auto message = [&](const std::string& variables) {
    return text::testing::error_of([&] { (void)study(variables); });
  };
  EXPECT_NE(message(R"("polarity": {"values": [[1, 1]]})").find("/variables/polarity/values/0: "), std::string::npos);
  EXPECT_NE(message(R"("polarity": {"values": [[1, 1, 1], [1, 1, 1]]})")
                .find("/variables/polarity/values/1: must not be there twice"),
            std::string::npos);
  EXPECT_NE(message(R"("polarity": {"values": [[1, 1, 1]]}, "configuration": {"values": ["A"]})")
                .find("/variables/configuration: must not vary beside \"polarity\": give whole rows, as values of "
                      "\"layout\""),
            std::string::npos);
  EXPECT_NE(message(R"("layout": {"values": [["magnet", "magnet"]]})").find("/variables/layout/values/0: layout"),
            std::string::npos);
}

TEST_F(StudyFile, DoesNotGiveUpARowForALetter) {
  const std::string study = R"({"format": "study/1", "name": "rows", "actuator": "row.json",
      "variables": {"configuration": {"values": ["A", "B"]}}, "operating_point": {"current_A": 1},
      "objectives": [{"maximise": "stroke_deg"}]})";
  const auto with_row = [&](const std::string& row) {
    return text::testing::error_of([&] {
      const text::InputText actuator{.file = "row.json", .text = R"({"format": "actuator/1", )" + row + "}"};
      (void)parse_study(study, "s.json", {.actuator = &actuator});
    });
  };
  EXPECT_EQ(with_row(R"("layout": ["coil", "magnet", "coil"], "polarity": [1, -1, 1])"),
            "s.json: /variables/configuration: would give up the actuator's own row (coil -magnet coil), which is none "
            "of the configurations: let \"layout\" vary ({\"values\": [[\"coil\", \"magnet\", \"coil\"], ...]}), or "
            "\"polarity\"");
  // A row that a letter has is no other one.
  EXPECT_EQ(with_row(R"("layout": ["coil", "magnet", "coil"])"), text::testing::error_of([] {}));
}

TEST_F(StudyFile, MayVaryAWireByItsDiameterAndASiliconeByItsName) {
  const auto study = [this](const std::string& variables) {
    return parse(R"({"format": "study/1", "name": "wires", "actuator": "sub/finger.json", "variables": {)" + variables +
                 R"(}, "operating_point": {"current_A": 1}, "objectives": [{"maximise": "stroke_deg"}]})");
  };
  const DesignProblem metric(study(
      R"("wire_diameter_mm": {"values": [0.2, 0.25]}, "silicone": {"values": ["Dragon Skin 20", "Dragon Skin 30"]})"));
  const actuator::Design design = metric.design_at(std::vector{1.0, 0.0});
  EXPECT_EQ(wire_of(design.coil).name(), "0.25 mm");
  EXPECT_EQ(design.body.name(), "Dragon Skin 20");
  // The actuator's gauge, as a diameter, where the search begins.
  const DesignProblem range(study(R"("wire_diameter_mm": {"lower": 0.1, "upper": 0.5})"));
  EXPECT_NEAR(range.problem().starts.at(0)[0], 1e3 * wire_of(range.study().base.coil).bare_diameter, 1e-12);
  EXPECT_NE(text::testing::error_of([&] {
              (void)study(R"("wire_diameter_mm": {"values": [0.2]}, "wire_gauge_AWG": {"values": [26, 28]})");
            }).find("/variables/wire_gauge_AWG: must not be there beside \"wire_diameter_mm\": both give the wire"),
            std::string::npos);
}

TEST_F(StudyFile, LimitsTheAngleOfASingleJoint) {
  const Study study = parse(R"({"format": "study/1", "name": "joints", "actuator": "sub/finger.json",
      "variables": {"gap_mm": {"values": [1, 1.2]}}, "operating_point": {"current_A": 1},
      "objectives": [{"maximise": "joint2_angle_deg"}],
      "constraints": [{"quantity": "rest_joint1_angle_deg", "at_least": 0}]})");
  EXPECT_NE(study.quantities.find("joint2_angle_deg"), nullptr);
  EXPECT_EQ(study.quantities.find("joint1_angle_deg"), nullptr);  // not asked for
  EXPECT_EQ(study.operating.cases, actuator::HeldCases::free);
}

TEST_F(StudyFile, MayVaryTheCurrentAndSayNothingElseOfIt) {
  const Study study = parse(R"({"format": "study/1", "name": "current", "actuator": "sub/finger.json",
      "variables": {"current_A": {"lower": -0.4, "upper": 1.2}}, "objectives": [{"maximise": "stroke_deg"}]})");
  EXPECT_TRUE(std::holds_alternative<VariedCurrent>(study.current));
  EXPECT_EQ(study.operating.duty, 1.0);
  EXPECT_EQ(study.search.max_evaluations, SearchOptions{}.max_evaluations);
}

// A speed is of the free finger, a grasp force of one that grips, also inside an expression; a mass is of neither.
TEST_F(StudyFile, IsHeldInThePosesThatItsQuantitiesAreOf) {
  const auto cases = [this](const std::string& point, const std::string& objective, const std::string& limit) {
    return parse(R"({"format": "study/1", "name": "held", "actuator": "sub/finger.json", "operating_point": {)" +
                 point + R"(}, "variables": {"current_A": {"lower": 0.4, "upper": 1.2}}, "objectives": [)" + objective +
                 R"(], "constraints": [)" + limit + "]}")
        .operating.cases;
  };
  const std::string speed = R"({"maximise": "peak_bending_speed_deg_s"})";
  const std::string light = R"({"minimise": "mass_g"})";
  const std::string grip = R"({"quantity": "grasp_force_N / mass_g", "name": "grip", "unit": "N/g", "at_least": 0.01})";
  const std::string cool = R"({"quantity": "thermal_load", "at_most": 1})";
  using actuator::HeldCases;
  EXPECT_EQ(cases("", speed, cool), HeldCases::free);
  EXPECT_EQ(cases("", light, grip), HeldCases::gripping);
  EXPECT_EQ(cases("", speed, grip), HeldCases::both);
  EXPECT_EQ(cases("", light, cool), HeldCases::both);
  EXPECT_EQ(cases(R"("cases": "both")", speed, cool), HeldCases::both);
  EXPECT_EQ(cases(R"("cases": "free")", speed, grip), HeldCases::free);
  // Without an operating point, too.
  EXPECT_EQ(parse(R"({"format": "study/1", "name": "held", "actuator": "sub/finger.json",
      "variables": {"current_A": {"lower": 0.4, "upper": 1.2}}, "objectives": [{"maximise": "stroke_deg"}]})")
                .operating.cases,
            HeldCases::free);
}

TEST_F(StudyFile, FromAFileIsTheSameAsFromItsText) {
  std::ofstream(folder_.path() / "s.json") << text;
  EXPECT_EQ(read_study(folder_.path() / "s.json").variables.size(), parse(text).variables.size());
}

TEST_F(StudyFile, NamesTheActuatorsFileForTheActuatorsFaults) {
  std::ofstream(folder_.path() / "sub/finger.json") << R"({"format": "actuator/1", "configuration": "X"})";
  const std::string error = text::testing::error_of([&] { (void)parse(text); });
  EXPECT_EQ(error, (folder_.path() / "sub/finger.json").string() +
                       R"(: /configuration: must be one of "A", "B", "C", "D"; got text "X")");
}

}  // namespace
}  // namespace coilwright::formats
