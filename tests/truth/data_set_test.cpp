#include "truth/data_set.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>

#include "degree.hpp"
#include "temporary_folder.hpp"
#include "truth/hidden_effects.hpp"
#include "truth/recording.hpp"

namespace truth {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(DataSet, IsTheMotionWithNoiseAndRounding) {
  const DataSet set = make_data_set({.seed = 7});
  Finger finger;
  finger.stiffness = set.answer.joint_stiffness;
  finger.damping = set.answer.joint_damping;
  double sum = 0.0, squares = 0.0, lagged = 0.0, before = 0.0;
  int count = 0;
  for (const RecordedRun& run : set.runs) {
    const Trajectory motion = simulate(finger, {}, run.experiment);
    for (std::size_t i = 0; i < motion.size(); ++i) {
      const double shown = run.angles_deg[i][0];
      EXPECT_NEAR(shown / 0.02, std::round(shown / 0.02), 1e-9);
      const double noise = shown - (motion[i][0] + motion[i][1]) / degree;
      sum += noise;
      squares += noise * noise;
      lagged += noise * before;
      before = noise;
      ++count;
    }
  }
  // Four standard errors of mean, standard deviation and correlation of neighbours.
  const double error = 4.0 / std::sqrt(count);
  EXPECT_NEAR(sum / count, 0.0, 0.3 * error);
  EXPECT_NEAR(std::sqrt(squares / count), 0.3, 0.3 * error / std::numbers::sqrt2);
  EXPECT_NEAR(lagged / squares, 0.0, error);
}

TEST(DataSet, ContainsThePapersExperiments) {
  const DataSet set = make_data_set({.seed = 1});
  int fit = 0;
  std::size_t samples = 0;
  std::set<std::string> names;
  for (const RecordedRun& run : set.runs) {
    names.insert(run.experiment.name);
    if (run.validate) continue;
    ++fit;
    samples += run.angles_deg.size();
  }
  EXPECT_EQ(fit, 10);
  EXPECT_NEAR(static_cast<double>(samples), 12000, 300);
  EXPECT_EQ(names.size(), set.runs.size());
  EXPECT_NE(set.answer.joint_stiffness, Finger{}.stiffness);
}

TEST(DataSet, HidesAnEffectOfTheStatedStrength) {
  for (const char* id : {"dry_friction", "measurement_delay", "end_stop", "shaken_base"}) {
    const DataSet set = make_data_set({.hidden = {id}, .seed = 21});
    ASSERT_EQ(set.answer.hidden.size(), 1u);
    const HiddenEffect& effect = set.answer.hidden[0];
    EXPECT_EQ(effect.id, id);
    EXPECT_GE(effect.asked, 3.0);
    EXPECT_LE(effect.asked, 15.0);
    const double is = hidden_kind(id).strength_beyond_calibration ? effect.strength_after_calibration : effect.strength;
    EXPECT_NEAR(is / effect.asked, 1.0, 0.02) << id;
    EXPECT_TRUE(effect.visible);
    // and in the data: the runs' residual to the finger without it, beside noise that adds in squares
    Finger finger;
    finger.stiffness = set.answer.joint_stiffness;
    finger.damping = set.answer.joint_damping;
    double largest = 0.0;
    for (const RecordedRun& run : set.runs) {
      if (run.validate) continue;
      const Trajectory motion = simulate(finger, {}, run.experiment);
      double squares = 0.0;
      for (std::size_t i = 0; i < motion.size(); ++i)
        squares += std::pow(run.angles_deg[i][0] * degree - motion[i][0] - motion[i][1], 2);
      largest = std::max(largest, squares / static_cast<double>(motion.size()));
    }
    const double seen = std::sqrt(largest / (set.answer.noise * set.answer.noise) - 1.0);
    EXPECT_NEAR(seen / effect.strength, 1.0, 0.1) << id;  // noise of 250 samples and more beside three times itself
  }
}

// At three times the noise a delay is like nothing but the lag of the current or of the tracker.
TEST(DataSet, NamesTheConfoundersOfItsEffect) {
  const DataSet set = make_data_set(
      {.hidden = {"measurement_delay"}, .seed = 8, .weakest = 3.0, .strongest = 3.5, .find_confounders = true});
  EXPECT_THAT(set.answer.hidden[0].confounders, testing::IsSubsetOf({"coil_lag", "tracking_lag"}));
}

TEST(DataSet, IsTheSameForTheSameRequest) {
  const DataSetRequest request{.hidden = {"hysteresis", "random_cable"}, .seed = 5};
  const DataSet first = make_data_set(request);
  const DataSet second = make_data_set(request);
  for (std::size_t i = 0; i < first.runs.size(); ++i) EXPECT_EQ(first.runs[i].angles_deg, second.runs[i].angles_deg);
  EXPECT_NE(first.runs[0].angles_deg, make_data_set({.hidden = request.hidden, .seed = 6}).runs[0].angles_deg);
}

TEST(DataSet, WritesTheFormatAndKeepsTheAnswerElsewhere) {
  const coilwright::testing::TemporaryFolder folder;
  const DataSet set = make_data_set({.hidden = {"force_gain"}, .seed = 2, .camera = Camera::joint_angles});
  write_data_set(set, folder.path() / "set");
  write_answer(set.answer, folder.path() / "answer.json");
  const auto index = nlohmann::json::parse(text_of(folder.path() / "set/dataset.json"));
  EXPECT_EQ(index.at("format"), "measured-data/1");
  EXPECT_EQ(index.at("tolerances"), "exact");
  EXPECT_EQ(index.at("runs").size(), set.runs.size());
  std::size_t files = 2;
  for (const auto& run : index.at("runs")) {
    const std::string text = text_of(folder.path() / "set" / run.at("file").get<std::string>());
    EXPECT_TRUE(text.starts_with("time_s,current_A,theta1_deg,theta2_deg\n0.000,"));
    ++files;
  }
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "set")) {
    EXPECT_EQ(text_of(entry.path()).find("force_gain"), std::string::npos);
    ++found;
  }
  EXPECT_EQ(found, files);
  const auto answer = nlohmann::json::parse(text_of(folder.path() / "answer.json"));
  EXPECT_EQ(answer.at("effects").at(0).at("id"), "force_gain");
  EXPECT_NE(answer.at("effects").at(0).at("parameters").at("gain"), 1.0);
}

}  // namespace
}  // namespace truth
