#include "coilwright/formats/actuator/pair_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {
using magnetics::CurrentDistribution;

const std::filesystem::path data = std::filesystem::path(COILWRIGHT_TEST_DATA) / "formats";

const std::string coil =
    R"({"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 10, "turns_radial": 8, "turns_axial": 20})";
const std::string magnet = R"({"radius_mm": 4, "length_mm": 6, "remanence_T": 1.3})";
const std::string poses = R"("poses": [{"position_mm": [0.5, 0, 12], "axis": [0, 0.1, 1]}])";

std::string refusal(const std::string& members) {
  return text::testing::error_of([&] { (void)parse_pair("{" + members + "}", "x.json"); });
}

std::string coil_and_magnet(const std::string& coil_text, const std::string& magnet_text) {
  return "\"coil\": " + coil_text + ", \"magnet\": " + magnet_text + ", \"current_A\": 1.4, " + poses;
}

TEST(PairFile, GivesACoilAndAMagnetInSi) {
  const PairFile file = read_pair(data / "pair.json");
  const auto& pair = std::get<CoilAndMagnet>(file.bodies);
  EXPECT_EQ(pair.coil.inner_radius(), 0.005);
  EXPECT_EQ(pair.coil.outer_radius(), 0.009);
  EXPECT_EQ(pair.coil.length(), 0.0105);
  EXPECT_EQ(pair.coil.turns_radial(), 8);
  EXPECT_EQ(pair.coil.turns_axial(), 20);
  EXPECT_EQ(pair.coil.winding(), CurrentDistribution::layer_centres);
  EXPECT_EQ(pair.magnet.radius(), 0.004);
  EXPECT_EQ(pair.magnet.length(), 0.006);
  EXPECT_EQ(pair.magnet.remanence(), 1.3);
  EXPECT_EQ(pair.current, 1.4);
  ASSERT_EQ(file.poses.size(), 2u);
  EXPECT_EQ(file.poses[0].position, Eigen::Vector3d(0.0005, -0.00025, 0.012));
  EXPECT_EQ(file.poses[1].axis, Eigen::Vector3d(0, 0, -2.5));
}

TEST(PairFile, GivesTwoCoilsWithACurrentEachOrOneForBoth) {
  const auto each = std::get<TwoCoils>(read_pair(data / "two_coils.json").bodies);
  EXPECT_EQ(each.first_current, 1.4);
  EXPECT_EQ(each.second_current, -0.7);
  EXPECT_EQ(each.second.inner_radius(), 0.0035);
  EXPECT_EQ(each.second.winding(), CurrentDistribution::uniform);
  const std::string both = "{\"coils\": [" + coil + "," + coil + "], \"current_A\": 0.7, " + poses + "}";
  const auto same = std::get<TwoCoils>(parse_pair(both, "x.json").bodies);
  EXPECT_EQ(same.first_current, 0.7);
  EXPECT_EQ(same.second_current, 0.7);
}

TEST(PairFile, GivesTwoMagnets) {
  const auto pair = std::get<TwoMagnets>(read_pair(data / "two_magnets.json").bodies);
  EXPECT_EQ(pair.first.remanence(), 1.3);
  EXPECT_EQ(pair.second.radius(), 0.005);
}

TEST(PairFile, RefusesBodiesThatAreMissingOrTooMany) {
  EXPECT_EQ(refusal(poses), "x.json: /: needs one of \"coil\", \"coils\", \"magnets\"");
  EXPECT_EQ(refusal("\"coil\": " + coil + ", \"current_A\": 1.4, " + poses), "x.json: /magnet: is missing");
  EXPECT_EQ(refusal("\"coils\": [" + coil + "], \"current_A\": 1.4, " + poses),
            "x.json: /coils: must have 2 elements; got an array of 1");
  EXPECT_EQ(refusal("\"magnets\": [" + magnet + "," + magnet + "], \"coil\": " + coil + ", " + poses),
            "x.json: /magnets: cannot stand beside \"coil\"");
}

TEST(PairFile, RefusesCurrentsThatAreMissingOrWithoutACoil) {
  EXPECT_EQ(refusal("\"coil\": " + coil + ", \"magnet\": " + magnet + ", " + poses), "x.json: /current_A: is missing");
  EXPECT_EQ(refusal("\"coils\": [" + coil + "," + coil + "], " + poses),
            "x.json: /: needs one of \"current_A\", \"currents_A\"");
  EXPECT_EQ(refusal("\"magnets\": [" + magnet + "," + magnet + "], \"current_A\": 2, " + poses),
            "x.json: /current_A: unknown key; the keys here are \"coil\", \"coils\", \"magnets\", \"poses\"");
}

TEST(PairFile, RefusesDimensionsThatCannotBe) {
  EXPECT_EQ(
      refusal(coil_and_magnet(
          R"({"inner_radius_mm": 5, "outer_radius_mm": 4.5, "length_mm": 10, "turns_radial": 8, "turns_axial": 2})",
          magnet)),
      "x.json: /coil/outer_radius_mm: must exceed inner_radius_mm (5); got 4.5");
  EXPECT_EQ(refusal(coil_and_magnet(
                R"({"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 10, "turns_radial": 0, "turns_axial": 2})",
                magnet)),
            "x.json: /coil/turns_radial: must be from 1 to 10000; got 0");
  EXPECT_EQ(refusal(coil_and_magnet(coil, R"({"radius_mm": 4, "length_mm": -6, "remanence_T": 1.3})")),
            "x.json: /magnet/length_mm: must be from 0.01 to 1000; got -6");
  EXPECT_EQ(refusal(coil_and_magnet(coil, R"({"radius_mm": 4, "length_mm": 6, "remanence_mT": 1300})")),
            "x.json: /magnet/remanence_mT: unknown key; did you mean \"remanence_T\"?");
  EXPECT_EQ(refusal(coil_and_magnet(coil, R"({"radius_mm": 1e-322, "length_mm": 6, "remanence_T": 1.3})")),
            "x.json: /magnet/radius_mm: must be from 0.01 to 1000; got 1e-322");
  EXPECT_EQ(
      refusal(coil_and_magnet(
          R"({"inner_radius_mm": 5, "outer_radius_mm": 5.0001, "length_mm": 10, "turns_radial": 8, "turns_axial": 2})",
          magnet)),
      "x.json: /coil/outer_radius_mm: must exceed inner_radius_mm (5) by at least 0.01; got 5.0001");
}

TEST(PairFile, RefusesNumbersThatNoHardwareHasAndNoFormulaSurvives) {
  EXPECT_EQ(refusal(coil_and_magnet(coil, R"({"radius_mm": 4, "length_mm": 6, "remanence_T": 1300})")),
            "x.json: /magnet/remanence_T: must be > 0 and <= 2; got 1300");
  EXPECT_EQ(refusal(coil_and_magnet(coil, R"({"radius_mm": 1e300, "length_mm": 6, "remanence_T": 1.3})")),
            "x.json: /magnet/radius_mm: must be from 0.01 to 1000; got 1e+300");
  EXPECT_EQ(refusal("\"magnets\": [" + magnet + "," + magnet +
                    R"(], "poses": [{"position_mm": [1, 2, 1e300], "axis": [0, 0, 1]}])"),
            "x.json: /poses/0/position_mm/2: must be from -1000000 to 1000000; got 1e+300");
}

TEST(PairFile, RefusesAWindingThatDoesNotExist) {
  EXPECT_EQ(refusal("\"winding\": \"papershells\", " + coil_and_magnet(coil, magnet)),
            "x.json: /winding: must be one of \"paper_shells\", \"layer_centres\", \"uniform\"; did you mean "
            "\"paper_shells\"?; "
            "got text \"papershells\"");
}

TEST(PairFile, RefusesPosesThatAreNone) {
  const std::string bodies = "\"coil\": " + coil + ", \"magnet\": " + magnet + ", \"current_A\": 1.4, ";
  EXPECT_EQ(refusal(bodies + R"("poses": [])"), "x.json: /poses: must have at least 1 element; got an array of 0");
  EXPECT_EQ(refusal(bodies + R"("poses": [{"position_mm": [1, 2], "axis": [0, 0, 1]}])"),
            "x.json: /poses/0/position_mm: must have 3 elements; got an array of 2");
  EXPECT_EQ(refusal(bodies + R"("poses": [{"position_mm": [1, 2, 3], "axis": [0, 0, 0]}])"),
            "x.json: /poses/0/axis: must be at least 1e-06 long, to give a direction");
}

}  // namespace
}  // namespace coilwright::formats
