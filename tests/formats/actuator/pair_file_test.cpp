#include "coilwright/formats/actuator/pair_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {
using magnetics::Cuboid;
using magnetics::CurrentDistribution;
using magnetics::DrivenCoil;
using magnetics::Magnet;
using magnetics::Ring;

const std::filesystem::path data = std::filesystem::path(COILWRIGHT_TEST_DATA) / "formats";

const std::string coil =
    R"({"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 10, "turns_radial": 8, "turns_axial": 20})";
const std::string magnet = R"({"radius_mm": 4, "length_mm": 6, "remanence_T": 1.3})";
const std::string poses = R"("poses": [{"position_mm": [0.5, 0, 12], "axis": [0, 0.1, 1]}])";

std::string pair_refusal(const std::string& members) {
  return text::testing::error_of([&] { (void)parse_pair("{" + members + "}", "x.json"); });
}

std::string coil_and_magnet(const std::string& coil_text, const std::string& magnet_text) {
  return "\"coil\": " + coil_text + ", \"magnet\": " + magnet_text + ", \"current_A\": 1.4, " + poses;
}

TEST(PairFile, GivesACoilAndAMagnetInSi) {
  const PairFile file = read_pair(data / "pair.json");
  ASSERT_EQ(file.bodies.size(), 2u);
  const auto& [winding, current] = std::get<DrivenCoil>(file.bodies[0].part);
  EXPECT_EQ(winding.inner_radius(), 0.005);
  EXPECT_EQ(winding.outer_radius(), 0.009);
  EXPECT_EQ(winding.length(), 0.0105);
  EXPECT_EQ(winding.turns_radial(), 8);
  EXPECT_EQ(winding.turns_axial(), 20);
  EXPECT_EQ(winding.winding(), CurrentDistribution::layer_centres);
  EXPECT_EQ(current, 1.4);
  const auto& posed = std::get<Magnet>(file.bodies[1].part);
  EXPECT_EQ(std::get<Ring>(posed.shape).inner_radius, 0.0);
  EXPECT_EQ(std::get<Ring>(posed.shape).outer_radius, 0.004);
  EXPECT_EQ(std::get<Ring>(posed.shape).length, 0.006);
  EXPECT_EQ(posed.remanence, Eigen::Vector3d(0.0, 0.0, 1.3));
  EXPECT_EQ(posed.recoil_permeability, 1.0);
  EXPECT_FALSE(file.listed);
  EXPECT_EQ(file.names, (std::vector<std::string>{"coil 1", "magnet 2"}));
  EXPECT_EQ(file.bodies[0].pose.axis, Eigen::Vector3d(0, 0, 1));
  ASSERT_EQ(file.poses.size(), 2u);
  EXPECT_EQ(file.poses[0].position, Eigen::Vector3d(0.0005, -0.00025, 0.012));
  EXPECT_EQ(file.poses[1].axis, Eigen::Vector3d(0, 0, -2.5));
}

TEST(PairFile, GivesTwoCoilsWithACurrentEachOrOneForBoth) {
  const auto coil_of = [](const PairFile& file, std::size_t i) { return std::get<DrivenCoil>(file.bodies[i].part); };
  const PairFile each = read_pair(data / "two_coils.json");
  EXPECT_EQ(coil_of(each, 0).current, 1.4);
  EXPECT_EQ(coil_of(each, 1).current, -0.7);
  EXPECT_EQ(coil_of(each, 1).coil.inner_radius(), 0.0035);
  EXPECT_EQ(coil_of(each, 1).coil.winding(), CurrentDistribution::uniform);
  const PairFile same =
      parse_pair("{\"coils\": [" + coil + "," + coil + "], \"current_A\": 0.7, " + poses + "}", "x.json");
  EXPECT_EQ(coil_of(same, 0).current, 0.7);
  EXPECT_EQ(coil_of(same, 1).current, 0.7);
}

TEST(PairFile, GivesTwoMagnets) {
  const PairFile file = read_pair(data / "two_magnets.json");
  EXPECT_EQ(std::get<Magnet>(file.bodies[0].part).remanence.z(), 1.3);
  EXPECT_EQ(std::get<Ring>(std::get<Magnet>(file.bodies[1].part).shape).outer_radius, 0.005);
}

const std::string list = R"("bodies": [
  {"name": "pole", "magnet": {"size_mm": [10, 8, 5], "remanence_T": 1.3, "magnetised_along": [0, 3, 4]},
   "position_mm": [1, 2, 4], "axis": [0, 0, 2], "x_axis": [1, 1, 0]},
  {"coil": )" + coil + R"(, "current_A": -2, "winding": "paper_shells", "position_mm": [0, 0, 20]},
  {"magnet": {"inner_radius_mm": 2, "outer_radius_mm": 6, "length_mm": 8, "remanence_T": 1.2,
              "recoil_permeability": 1.05}, "position_mm": [0, 0, 40], "axis": [1, 0, 0]}])";

TEST(PairFile, GivesAListOfBodiesWithAPlate) {
  const PairFile file = parse_pair("{" + list + R"(, "plate": {"thickness_mm": 3, "relative_permeability": 500,
      "position_mm": [0, 0, 1], "normal": [0, 0, 3], "radius_mm": 50}})",
                                   "x.json");
  EXPECT_TRUE(file.listed);
  EXPECT_EQ(file.names, (std::vector<std::string>{"pole", "coil 2", "magnet 3"}));
  const auto& block = std::get<Magnet>(file.bodies[0].part);
  EXPECT_EQ(std::get<Cuboid>(block.shape).size, Eigen::Vector3d(0.01, 0.008, 0.005));
  EXPECT_LT((block.remanence - 1.3 * Eigen::Vector3d(0.0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(file.bodies[0].pose.x_axis, Eigen::Vector3d(1, 1, 0));
  EXPECT_EQ(std::get<DrivenCoil>(file.bodies[1].part).current, -2.0);
  EXPECT_EQ(std::get<DrivenCoil>(file.bodies[1].part).coil.winding(), CurrentDistribution::paper_shells);
  EXPECT_EQ(std::get<Ring>(std::get<Magnet>(file.bodies[2].part).shape).inner_radius, 0.002);
  EXPECT_EQ(std::get<Magnet>(file.bodies[2].part).recoil_permeability, 1.05);
  ASSERT_EQ(file.poses.size(), 1u);
  EXPECT_EQ(file.poses[0].position, Eigen::Vector3d(0, 0, 0.04));
  ASSERT_TRUE(file.plate);
  EXPECT_EQ(file.plate->thickness, 0.003);
  EXPECT_EQ(file.plate->position, Eigen::Vector3d(0, 0, 0.001));
  EXPECT_EQ(file.plate->relative_permeability, 500.0);
  EXPECT_EQ(file.plate_radius, 0.05);
}

TEST(PairFile, MovesTheLastBodyOfAListThroughItsPoses) {
  const std::string last = R"({"magnet": )" + magnet + "}";
  const PairFile file = parse_pair(R"({"bodies": [{"magnet": )" + magnet + R"(, "position_mm": [0, 0, -9]}, )" + last +
                                       R"(], "poses": [{"position_mm": [0, 0, 5], "axis": [0, 0, 1]},
                                          {"position_mm": [0, 0, 7], "axis": [0, 0, -1]}]})",
                                   "x.json");
  ASSERT_EQ(file.poses.size(), 2u);
  EXPECT_EQ(file.bodies_at(file.poses[1])[1].pose.position.z(), 0.007);
  EXPECT_EQ(file.bodies_at(file.poses[1])[0].pose.position.z(), -0.009);
  EXPECT_EQ(file.bodies[1].pose.position.z(), 0.005);
}

TEST(PairFile, RefusesListsThatCannotBe) {
  EXPECT_EQ(pair_refusal(R"("bodies": [])"), "x.json: /bodies: must have 1 to 200 elements; got an array of 0");
  EXPECT_EQ(pair_refusal(R"("bodies": [{"position_mm": [0, 0, 1]}])"),
            "x.json: /bodies/0: needs one of \"coil\", \"magnet\"");
  EXPECT_EQ(pair_refusal(R"("bodies": [{"coil": )" + coil + "}]"), "x.json: /bodies/0/current_A: is missing");
  EXPECT_EQ(pair_refusal(R"("bodies": [{"magnet": )" + magnet + R"(, "current_A": 1}])"),
            "x.json: /bodies/0/current_A: unknown key; the keys here are \"axis\", \"coil\", \"magnet\", \"name\", "
            "\"position_mm\", \"x_axis\"");
  EXPECT_EQ(pair_refusal(R"("bodies": [{"magnet": )" + magnet + R"(, "axis": [0, 0, 1], "x_axis": [0, 0, 2]}])"),
            "x.json: /bodies/0/x_axis: must not lie along \"axis\"");
  EXPECT_EQ(pair_refusal(R"("bodies": [{"magnet": {"size_mm": [10, 0.001, 5], "remanence_T": 1.3}}])"),
            "x.json: /bodies/0/magnet/size_mm/1: must be from 0.05 to 1000; got 0.001");
  EXPECT_EQ(
      pair_refusal(
          R"("bodies": [{"magnet": {"inner_radius_mm": 5, "outer_radius_mm": 5, "length_mm": 5, "remanence_T": 1.3}}])"),
      "x.json: /bodies/0/magnet/outer_radius_mm: must exceed inner_radius_mm (5) by at least 0.05; got 5");
  EXPECT_EQ(
      pair_refusal(
          R"("bodies": [{"magnet": {"radius_mm": 5, "length_mm": 5, "remanence_T": 1.3, "magnetised_along": [0, 0, 0]}}])"),
      "x.json: /bodies/0/magnet/magnetised_along: must be at least 1e-06 long, to give a direction");
}

TEST(PairFile, RefusesAPlateThatBodiesStandIn) {
  EXPECT_EQ(
      pair_refusal(list + R"(, "plate": {"thickness_mm": 3, "position_mm": [0, 0, 2]})"),
      "x.json: /plate: must have every body in front of its face, on the side to which \"normal\" points; magnet 1 "
      "reaches 0.5 mm behind it");
  EXPECT_EQ(pair_refusal(list + R"(, "plate": {"thickness_mm": 3, "relative_permeability": 5})"),
            "x.json: /plate/relative_permeability: must be from 50 to 1000000; got 5");
}

TEST(PairFile, RefusesBodiesThatAreMissingOrTooMany) {
  EXPECT_EQ(pair_refusal(poses), "x.json: /: needs one of \"bodies\", \"coil\", \"coils\", \"magnets\"");
  EXPECT_EQ(pair_refusal("\"coil\": " + coil + ", \"current_A\": 1.4, " + poses), "x.json: /magnet: is missing");
  EXPECT_EQ(pair_refusal("\"coils\": [" + coil + "], \"current_A\": 1.4, " + poses),
            "x.json: /coils: must have 2 elements; got an array of 1");
  EXPECT_EQ(pair_refusal("\"magnets\": [" + magnet + "," + magnet + "], \"coil\": " + coil + ", " + poses),
            "x.json: /magnets: cannot stand beside \"coil\"");
}

TEST(PairFile, RefusesCurrentsThatAreMissingOrWithoutACoil) {
  EXPECT_EQ(pair_refusal("\"coil\": " + coil + ", \"magnet\": " + magnet + ", " + poses),
            "x.json: /current_A: is missing");
  EXPECT_EQ(pair_refusal("\"coils\": [" + coil + "," + coil + "], " + poses),
            "x.json: /: needs one of \"current_A\", \"currents_A\"");
  EXPECT_EQ(
      pair_refusal("\"magnets\": [" + magnet + "," + magnet + "], \"current_A\": 2, " + poses),
      "x.json: /current_A: unknown key; the keys here are \"bodies\", \"coil\", \"coils\", \"magnets\", \"plate\", "
      "\"poses\"");
}

TEST(PairFile, RefusesDimensionsThatCannotBe) {
  EXPECT_EQ(
      pair_refusal(coil_and_magnet(
          R"({"inner_radius_mm": 5, "outer_radius_mm": 4.5, "length_mm": 10, "turns_radial": 8, "turns_axial": 2})",
          magnet)),
      "x.json: /coil/outer_radius_mm: must exceed inner_radius_mm (5); got 4.5");
  EXPECT_EQ(pair_refusal(coil_and_magnet(
                R"({"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 10, "turns_radial": 0, "turns_axial": 2})",
                magnet)),
            "x.json: /coil/turns_radial: must be from 1 to 10000; got 0");
  EXPECT_EQ(pair_refusal(coil_and_magnet(coil, R"({"radius_mm": 4, "length_mm": -6, "remanence_T": 1.3})")),
            "x.json: /magnet/length_mm: must be from 0.05 to 1000; got -6");
  EXPECT_EQ(pair_refusal(coil_and_magnet(coil, R"({"radius_mm": 4, "length_mm": 6, "remanence_mT": 1300})")),
            "x.json: /magnet/remanence_mT: unknown key; did you mean \"remanence_T\"?");
  EXPECT_EQ(pair_refusal(coil_and_magnet(coil, R"({"radius_mm": 1e-322, "length_mm": 6, "remanence_T": 1.3})")),
            "x.json: /magnet/radius_mm: must be from 0.05 to 1000; got 1e-322");
  EXPECT_EQ(
      pair_refusal(coil_and_magnet(
          R"({"inner_radius_mm": 5, "outer_radius_mm": 5.0001, "length_mm": 10, "turns_radial": 8, "turns_axial": 2})",
          magnet)),
      "x.json: /coil/outer_radius_mm: must exceed inner_radius_mm (5) by at least 0.05; got 5.0001");
}

TEST(PairFile, RefusesNumbersThatNoHardwareHasAndNoFormulaSurvives) {
  EXPECT_EQ(pair_refusal(coil_and_magnet(coil, R"({"radius_mm": 4, "length_mm": 6, "remanence_T": 1300})")),
            "x.json: /magnet/remanence_T: must be > 0 and <= 2; got 1300");
  EXPECT_EQ(pair_refusal(coil_and_magnet(coil, R"({"radius_mm": 1e300, "length_mm": 6, "remanence_T": 1.3})")),
            "x.json: /magnet/radius_mm: must be from 0.05 to 1000; got 1e+300");
  EXPECT_EQ(pair_refusal("\"magnets\": [" + magnet + "," + magnet +
                         R"(], "poses": [{"position_mm": [1, 2, 1e300], "axis": [0, 0, 1]}])"),
            "x.json: /poses/0/position_mm/2: must be from -1000000 to 1000000; got 1e+300");
}

TEST(PairFile, RefusesAWindingThatDoesNotExist) {
  EXPECT_EQ(pair_refusal("\"winding\": \"papershells\", " + coil_and_magnet(coil, magnet)),
            "x.json: /winding: must be one of \"paper_shells\", \"layer_centres\", \"uniform\"; did you mean "
            "\"paper_shells\"?; "
            "got text \"papershells\"");
}

TEST(PairFile, RefusesPosesThatAreNone) {
  const std::string bodies = "\"coil\": " + coil + ", \"magnet\": " + magnet + ", \"current_A\": 1.4, ";
  EXPECT_EQ(pair_refusal(bodies + R"("poses": [])"), "x.json: /poses: must have at least 1 element; got an array of 0");
  EXPECT_EQ(pair_refusal(bodies + R"("poses": [{"position_mm": [1, 2], "axis": [0, 0, 1]}])"),
            "x.json: /poses/0/position_mm: must have 3 elements; got an array of 2");
  EXPECT_EQ(pair_refusal(bodies + R"("poses": [{"position_mm": [1, 2, 3], "axis": [0, 0, 0]}])"),
            "x.json: /poses/0/axis: must be at least 1e-06 long, to give a direction");
}

}  // namespace
}  // namespace coilwright::formats
