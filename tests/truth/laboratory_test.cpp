// The faults of a laboratory: each is in the record as the answer says, and the keys of the set tell what they may.

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "degree.hpp"
#include "temporary_folder.hpp"
#include "truth/hidden_effects.hpp"
#include "truth/laboratory/laboratory_set.hpp"
#include "truth/laboratory/noise.hpp"

namespace truth::laboratory {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

nlohmann::json index_of(const Request& request) {
  const coilwright::testing::TemporaryFolder folder;
  write_laboratory_set(make_laboratory_set(request), folder.path());
  return nlohmann::json::parse(text_of(folder.path() / "dataset.json"));
}

// The bending angle at given times of the input, rad.
std::vector<double> motion_at(const LaboratorySet& set, const RecordedRun& run, std::vector<double> times) {
  Experiment experiment = run.planned.experiment;
  for (double& time : times) time = std::max(time, 0.0);
  experiment.seen = std::move(times);
  std::vector<double> out;
  for (const auto& angles : simulate(set.answer.built.finger, {}, experiment)) out.push_back(angles[0] + angles[1]);
  return out;
}

// What a record shows beyond the motion of the finger at its stamps on that clock, deg.
std::vector<double> left_over(const LaboratorySet& set, const RecordedRun& run, const RunClock& clock) {
  std::vector<double> times;
  for (const double stamp : run.stamps) times.push_back(run.planned.begins + (1.0 + clock.rate) * stamp + clock.offset);
  const std::vector<double> is = motion_at(set, run, times);
  std::vector<double> out;
  for (std::size_t i = 0; i < is.size(); ++i) out.push_back(run.angles_deg[i][0] - is[i] / degree);
  return out;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(Clocks, ReadAnotherTimeInEachRun) {
  Request request{.seed = 3, .programme = Programme::few};
  request.camera.frame_rate = 120.0;
  request.clocks = {.log = InputLog::own_samples, .smallest_offset = 0.005, .largest_offset = 0.015, .rate = 0.005};
  const LaboratorySet set = make_laboratory_set(request);
  std::vector<double> offsets;
  for (const RecordedRun& run : set.runs) {
    EXPECT_GE(std::abs(run.clock.offset), 0.005);
    EXPECT_LE(std::abs(run.clock.offset), 0.015);
    EXPECT_DOUBLE_EQ(std::abs(run.clock.rate), 0.005);
    EXPECT_EQ(run.clock.rate, set.runs[0].clock.rate);
    offsets.push_back(run.clock.offset);
    // 0.298 deg; 84 to 96 pictures: an error of a tenth and less.
    EXPECT_NEAR(rms(left_over(set, run, run.clock)), 0.298, 0.1) << run.planned.experiment.name;
    EXPECT_GT(rms(left_over(set, run, {})), 0.45) << run.planned.experiment.name;
    ASSERT_EQ(run.input_times.size(), run.currents.size());
    EXPECT_DOUBLE_EQ(run.input_times[1] - run.input_times[0], 0.005);
  }
  EXPECT_NE(offsets[0], offsets[1]);
}

TEST(Clocks, LetTheCameraBeginAfterTheInput) {
  Request request{.seed = 3, .programme = Programme::sines};
  request.camera.frame_rate = 120.0;
  request.clocks = {.log = InputLog::own_samples, .latest_start = 0.05};
  const LaboratorySet set = make_laboratory_set(request);
  for (const RecordedRun& run : set.runs) {
    EXPECT_GT(run.stamps.front(), 0.0);
    EXPECT_LT(run.stamps.front(), 0.05);
    EXPECT_LT(run.stamps.back(), run.planned.duration);
    EXPECT_EQ(run.input_times.front(), 0.0);
    EXPECT_NEAR(rms(left_over(set, run, {})), 0.298, 0.1) << run.planned.experiment.name;
  }
  EXPECT_NE(set.runs[0].stamps.front(), set.runs[1].stamps.front());
}

TEST(Clocks, LeaveEdgesBetweenPictures) {
  Request request{.seed = 5, .programme = Programme::few};
  request.camera.frame_rate = 60.0;
  const LaboratorySet set = make_laboratory_set(request);
  for (const RecordedRun& run : set.runs) {
    const auto& times = run.planned.experiment.times;
    const auto& currents = run.planned.experiment.currents;
    std::size_t edge = 1;
    while (currents[edge] == currents[edge - 1]) ++edge;
    std::size_t after = 1;
    while (run.currents[after] == run.currents[after - 1]) ++after;
    EXPECT_GT(times[edge], run.stamps[after - 1]);
    EXPECT_LT(times[edge], run.stamps[after]);
    EXPECT_EQ(run.currents[after], currents[edge]);
  }
}

// An input that is declared to go straight between its samples does.
TEST(Inputs, GoStraightBetweenTheSamplesOfSmoothRuns) {
  Request request{.seed = 5, .programme = Programme::sines};
  request.camera.frame_rate = 30.0;
  const LaboratorySet set = make_laboratory_set(request);
  const RecordedRun& fast = set.runs[3];  // 8 Hz: four samples a period
  const Experiment& driven = fast.planned.experiment;
  for (std::size_t i = 0; i + 1 < fast.input_times.size(); ++i) {
    const double middle = 0.5 * (fast.input_times[i] + fast.input_times[i + 1]);
    const auto at = static_cast<std::size_t>(middle / 0.5e-3);
    EXPECT_NEAR(driven.currents[at], 0.5 * (fast.currents[i] + fast.currents[i + 1]),
                0.5e-3 * 30.0 * std::abs(fast.currents[i + 1] - fast.currents[i]) + 1e-12);
  }
  EXPECT_NEAR(fast.currents[1], 0.7 + 0.7 * std::sin(2.0 * std::numbers::pi * 8.0 / 30.0), 1e-12);
}

TEST(Exposure, AveragesWhatThePictureSees) {
  Request request{.seed = 4, .programme = Programme::sines};
  request.camera = {.frame_rate = 30.0, .exposure_share = 0.8};
  request.noise.level = 1e-6;  // below the resolution
  const LaboratorySet set = make_laboratory_set(request);
  const RecordedRun& fast = set.runs[3];  // 8 Hz
  const double exposure = 0.8 / 30.0;
  std::vector<double> differences;
  std::vector<double> sharp;
  for (std::size_t i = 5; i < 25; ++i) {
    std::vector<double> times;
    constexpr int points = 400;
    for (int k = 0; k < points; ++k) times.push_back(fast.stamps[i] + exposure * ((k + 0.5) / points - 0.5));
    const std::vector<double> inside = motion_at(set, fast, times);
    double mean = 0.0;
    for (const double angle : inside) mean += angle / degree / points;
    differences.push_back(fast.angles_deg[i][0] - mean);
    sharp.push_back(fast.angles_deg[i][0] - inside[points / 2] / degree);
  }
  EXPECT_LT(rms(differences), 0.02);  // the resolution, which is three times its rms, and the rule of three points
  EXPECT_GT(rms(sharp), 0.3);
}

// Against the theory of each colour, with four standard errors of a correlation over so many independent stretches.
TEST(NoiseOfTheCamera, HasItsLevelAndColour) {
  constexpr double interval = 1.0 / 120.0;
  constexpr int count = 40000;
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(i * interval);
  const auto correlation = [&](Colour colour, int lag) {
    Random random(12);
    const std::vector<double> values = Noise(colour, random).at(times);
    double sum = 0.0;
    for (int i = 0; i + lag < count; ++i) sum += values[i] * values[i + lag];
    return sum / (count - lag);
  };
  for (const Colour colour : {Colour::white, Colour::low_passed, Colour::hum})
    EXPECT_NEAR(correlation(colour, 0), 1.0, 0.05);
  EXPECT_NEAR(correlation(Colour::white, 1), 0.0, 0.02);
  const double kept = std::exp(-2.0 * std::numbers::pi * 10.0 * interval);
  EXPECT_NEAR(correlation(Colour::low_passed, 1), kept, 0.03);
  EXPECT_NEAR(correlation(Colour::low_passed, 2), kept * kept, 0.03);
  // Half of the variance in the line: five periods are twelve pictures.
  EXPECT_NEAR(correlation(Colour::hum, 12), 0.5, 0.02);
  EXPECT_NEAR(correlation(Colour::hum, 6), -0.5, 0.02);
  // Slow filters have not averaged out over 333 s: a tenth.
  double pink = 0.0;
  for (int i = 0; i < 8; ++i)
    pink += std::exp(-2.0 * std::numbers::pi * 0.03 * std::pow(100.0 / 0.03, i / 7.0) * interval) / 8.0;
  EXPECT_NEAR(correlation(Colour::pink, 1) / correlation(Colour::pink, 0), pink, 0.05);
  EXPECT_NEAR(correlation(Colour::pink, 0), 1.0, 0.2);
}

// What is left of noise over its own colour is white, and has its level.
TEST(NoiseOfTheCamera, IsWhiteOverItself) {
  Random random(12);
  std::vector<double> times;
  for (int i = 0; i < 4000; ++i) times.push_back(i / 120.0);
  for (const Colour colour : {Colour::white, Colour::low_passed, Colour::pink, Colour::hum}) {
    const std::vector<double> values = Noise(colour, random).at(times);
    const Eigen::VectorXd left =
        over_noise(colour, 1e-6, times, Eigen::Map<const Eigen::VectorXd>(values.data(), 4000));
    EXPECT_NEAR(left.squaredNorm() / 4000.0, 1.0, 0.07) << static_cast<int>(colour);
    for (const int lag : {1, 2, 12})
      EXPECT_NEAR(left.head(4000 - lag).dot(left.tail(4000 - lag)) / 4000.0, 0.0, 0.05) << lag;
  }
}

TEST(Outliers, AreWhereTheAnswerSays) {
  Request request{.seed = 6, .programme = Programme::few};
  request.camera.frame_rate = 240.0;
  request.clocks.log = InputLog::every_change;
  request.noise.outliers = 0.04;
  const LaboratorySet set = make_laboratory_set(request);
  std::size_t pictures = 0;
  std::size_t wrong = 0;
  for (const RecordedRun& run : set.runs) {
    const std::vector<double> left = left_over(set, run, run.clock);
    std::size_t next = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const bool listed = next < run.outliers.size() && run.outliers[next].time == run.stamps[i];
      EXPECT_EQ(std::abs(left[i]) > 1.5, listed) << left[i];  // five standard deviations of the noise
      if (!listed) continue;
      EXPECT_NEAR(left[i], run.outliers[next].by / degree, 1.5);
      EXPECT_GE(std::abs(run.outliers[next].by / degree), 3.0 - 0.011);
      EXPECT_LE(std::abs(run.outliers[next].by / degree), 10.0 + 0.011);
      ++next;
    }
    pictures += left.size();
    wrong += run.outliers.size();
  }
  EXPECT_NEAR(static_cast<double>(wrong) / static_cast<double>(pictures), 0.04, 0.02);
}

TEST(InputNoise, IsInTheRecordAlone) {
  Request request{.seed = 9, .programme = Programme::few};
  const LaboratorySet quiet = make_laboratory_set(request);
  request.noise.input_noise = 0.02;
  const LaboratorySet noisy = make_laboratory_set(request);
  EXPECT_EQ(quiet.runs[0].angles_deg, noisy.runs[0].angles_deg);
  std::vector<double> difference;
  for (std::size_t i = 0; i < quiet.runs[0].currents.size(); ++i)
    difference.push_back(noisy.runs[0].currents[i] - quiet.runs[0].currents[i]);
  EXPECT_NEAR(rms(difference), 0.02, 0.004);
}

TEST(DeclaredNumbers, AreOffByWhatTheAnswerSays) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const BuiltFinger within = build_finger(random, Deviation::within, Tolerances::listed);
    double sum = 0.0;
    for (const Number& number : within.numbers) {
      EXPECT_FALSE(number.far);
      EXPECT_LE(std::abs(number.is - number.declared), 2.0 * number.tolerance * (1.0 + 1e-9)) << number.name;
      sum += std::pow((number.is - number.declared) / number.tolerance, 2);
    }
    EXPECT_LT(sum, 20.09);  // 1 in 100 of eight numbers
    const BuiltFinger far = build_finger(random, Deviation::far, Tolerances::listed);
    int moved = 0;
    for (const Number& number : far.numbers) {
      const double off = std::abs(number.is - number.declared) / number.tolerance;
      moved += number.far ? 1 : 0;
      EXPECT_EQ(off > 7.0, number.far) << number.name;
      EXPECT_TRUE(number.far || off <= 2.0 + 1e-9) << number.name;
    }
    EXPECT_GE(moved, 1);
  }
  Random random(1);
  const BuiltFinger exact = build_finger(random, Deviation::none, Tolerances::exact);
  EXPECT_EQ(exact.finger.second_mass, Finger{}.second_mass);
  EXPECT_NE(exact.finger.stiffness, Finger{}.stiffness);
}

// The rms over the angles of the curve, by another rule than the one that scales it.
TEST(DeclaredNumbers, IncludeASmoothErrorOfTheCurve) {
  Random random(8);
  const BuiltFinger built = build_finger(random, Deviation::far, Tolerances::absent);
  double squares = 0.0;
  double largest = 0.0;
  double largest_slope = 0.0;
  for (int i = 0; i <= 900; ++i) {
    const double angle = (-20.0 + 0.1 * i) * degree;
    squares += std::pow(curve_error(built.finger.curve_error, angle), 2);
    largest = std::max(largest, std::abs(curve_error(built.finger.curve_error, angle)));
    largest_slope = std::max(largest_slope, std::abs(curve_error(built.finger.curve_error, angle + 1e-4) -
                                                     curve_error(built.finger.curve_error, angle)) /
                                                1e-4);
  }
  std::map<std::string, double> is;
  for (const Number& number : built.numbers) {
    is[number.name] = number.is;
  }
  EXPECT_NEAR(std::sqrt(squares / 901) / is.at("force_curve"), 1.0, 0.01);
  EXPECT_DOUBLE_EQ(built.finger.first_mass, is.at("/links/0/mass_kg"));
  EXPECT_DOUBLE_EQ(built.finger.second_mass, is.at("/links/1/mass_kg"));
  EXPECT_DOUBLE_EQ(built.finger.second_com, is.at("/links/1/com_along_m"));
  EXPECT_DOUBLE_EQ(built.finger.force_factor[0] * 1.44, is.at("/magnetics/0/magnet/remanence_T"));
  EXPECT_DOUBLE_EQ(built.finger.force_factor[1] * 1.44, is.at("/magnetics/1/magnet/remanence_T"));
  EXPECT_DOUBLE_EQ(built.finger.second_stiffness_ratio, is.at("joint_stiffness_ratio"));
  EXPECT_DOUBLE_EQ(built.finger.second_damping_ratio, is.at("joint_damping_ratio"));
  // Markov's inequality for a polynomial of degree 4 on 90 degrees, which a kink would break.
  EXPECT_LT(largest_slope, 16.0 * largest / (45.0 * degree) * (1.0 + 1e-3));
}

TEST(DeclaredFaces, AreTouchedInARelease) {
  for (const DeclaredFaces faces : {DeclaredFaces::absent, DeclaredFaces::elsewhere}) {
    const LaboratorySet set = make_laboratory_set({.seed = 2, .programme = Programme::few, .faces = faces});
    const Faces& declared = set.answer.declared_faces;
    EXPECT_GT(declared.stiffness, 0.0);
    Finger as_declared = set.answer.built.finger;
    as_declared.faces = declared;
    const Experiment& release = set.runs[3].planned.experiment;
    EXPECT_EQ(set.runs[3].planned.experiment.name, "release_1.4A");
    const Trajectory declares = simulate(as_declared, {}, release);
    const Trajectory is = simulate(set.answer.built.finger, {}, release);
    double largest = 0.0;
    for (std::size_t i = 0; i < is.size(); ++i)
      largest = std::max(largest, std::abs(is[i][0] + is[i][1] - declares[i][0] - declares[i][1]));
    EXPECT_GT(largest, 2.0 * degree);
    if (faces == DeclaredFaces::elsewhere) {
      EXPECT_NEAR(std::abs(set.answer.built.finger.faces.angle - declared.angle), 3.0 * degree, 1e-12);
    } else {
      EXPECT_EQ(set.answer.built.finger.faces.stiffness, 0.0);
    }
  }
}

TEST(LaboratorySet, SaysOnlyWhatItIsAskedToSay) {
  const auto plain = index_of({.seed = 1});
  EXPECT_EQ(plain.at("tolerances"), "exact");
  for (const auto& run : plain.at("runs"))
    for (const char* key : {"input_file", "input_hold", "clock_offset_s", "clock_rate", "exposure_s", "sigma", "rig"})
      EXPECT_FALSE(run.contains(key)) << key;

  Request request{.seed = 1, .programme = Programme::few, .tolerances = Tolerances::listed};
  request.camera = {.frame_rate = 60.0, .exposure_share = 0.5};
  request.clocks = {.log = InputLog::own_samples, .smallest_offset = 0.005, .largest_offset = 0.015, .rate = 0.005};
  request.noise.still_run = true;
  request.noise.sigma_given = true;
  const auto full = index_of(request);
  EXPECT_EQ(full.at("tolerances").at("/links/1/mass_kg"), 0.0225 * 0.05);
  EXPECT_EQ(full.at("tolerances").size(), 8u);
  const auto& still = full.at("runs").at(0);
  EXPECT_EQ(still.at("kind"), "still");
  EXPECT_FALSE(still.contains("drive"));
  const auto& step = full.at("runs").at(1);
  EXPECT_EQ(step.at("input_file"), "step_0.35A_input.csv");
  EXPECT_EQ(step.at("input_hold"), "unknown_within_sample");
  EXPECT_EQ(step.at("clock_offset_s"), 0.01);
  EXPECT_EQ(step.at("clock_rate"), 0.005);
  EXPECT_EQ(step.at("exposure_s"), 0.5 / 60.0);
  EXPECT_NEAR(step.at("sigma").get<double>(), 0.298, 1e-3);

  request.tolerances = Tolerances::absent;
  request.programme = Programme::sines;
  const auto absent = index_of(request);
  EXPECT_FALSE(absent.contains("tolerances"));
  EXPECT_EQ(absent.at("runs").at(1).at("input_hold"), "linear");
}

TEST(LaboratorySet, WritesTheInputBesideTheRunOrInItsOwnFile) {
  const coilwright::testing::TemporaryFolder folder;
  Request request{.seed = 1, .programme = Programme::rig_changes};
  write_laboratory_set(make_laboratory_set(request), folder.path() / "a");
  EXPECT_TRUE(text_of(folder.path() / "a/step_0.5A.csv").starts_with("time_s,current_A,bending_angle_deg\n0.000000,"));
  request.clocks.log = InputLog::every_change;
  write_laboratory_set(make_laboratory_set(request), folder.path() / "b");
  EXPECT_TRUE(text_of(folder.path() / "b/step_0.5A.csv").starts_with("time_s,bending_angle_deg\n0.000000,"));
  EXPECT_TRUE(text_of(folder.path() / "b/step_0.5A_input.csv").starts_with("time_s,current_A\n0.000000,0.000000\n"));
  const auto index = nlohmann::json::parse(text_of(folder.path() / "b/dataset.json"));
  std::vector<std::string> rigs;
  for (const auto& run : index.at("runs"))
    if (run.contains("rig")) rigs.push_back(run.at("rig").dump());
  EXPECT_THAT(rigs, testing::ElementsAre(R"({"base_turn_deg":30.0})", R"({"base_turn_deg":-30.0})",
                                         R"({"tip_mass_g":5.0})", R"({"coil":"open"})"));
  // Nobody drives a finger that is let go, and the record begins in its motion.
  const std::string open = text_of(folder.path() / "b/release_open_input.csv");
  EXPECT_EQ(open.find("1.4"), std::string::npos);
}

TEST(LaboratorySet, HidesEveryKindInAnyProgramme) {
  std::uint64_t seed = 1;
  for (const HiddenKind& kind : hidden_kinds()) {
    Request request{.hidden = {kind.name()}, .seed = seed, .programme = Programme::few};
    request.camera.frame_rate = 60.0;
    // Nothing drifts in a single run; the long programmes take their time.
    request.programme =
        std::array{Programme::few, Programme::few, Programme::few, Programme::sines, Programme::rig_changes}.at(seed++ %
                                                                                                                5);
    const LaboratorySet set = make_laboratory_set(request);
    ASSERT_EQ(set.answer.common.hidden.size(), 1u);
    const HiddenEffect& effect = set.answer.common.hidden[0];
    EXPECT_EQ(effect.id, kind.id);
    EXPECT_GT(effect.strength, 0.0) << kind.name();
    EXPECT_LE(effect.share_of_bound, 1.0) << kind.name();
  }
}

TEST(LaboratorySet, HidesAnEffectAtAValueOrAtItsBound) {
  Request request{.hidden = {"force_gain", "measurement_delay"}, .seed = 4, .programme = Programme::few};
  request.values = {1.05, 8.0};
  const LaboratorySet set = make_laboratory_set(request);
  EXPECT_NEAR(set.answer.common.hidden[0].numbers[0].value, 1.05, 1e-12);
  EXPECT_NEAR(set.answer.common.hidden[1].numbers[0].value, 8.0, 1e-12);
  const LaboratorySet bound = make_laboratory_set(
      {.hidden = {"angle_offset"}, .seed = 4, .programme = Programme::few, .strongest = 1e3, .at_bound = true});
  EXPECT_NEAR(std::abs(bound.answer.common.hidden[0].numbers[0].value), 0.17 / degree, 1e-9);
  EXPECT_DOUBLE_EQ(bound.answer.common.hidden[0].share_of_bound, 1.0);
  EXPECT_THROW((void)make_laboratory_set({.hidden = {"force_gain"}, .values = {1.0, 2.0}}), std::invalid_argument);
}

// What tolerances can do is no effect's: the less a set vouches for, the less is left of an effect.
TEST(LaboratorySet, KnowsWhatTolerancesAndClocksLeaveOfAnEffect) {
  const auto evidence = [](const std::string& id, double value, const auto& change) {
    Request request{.hidden = {id}, .seed = 12, .programme = Programme::few};
    request.camera.frame_rate = 120.0;
    request.clocks.log = InputLog::every_change;
    request.values = {value};
    change(request);
    return make_laboratory_set(request).answer.common.hidden[0];
  };
  const auto nothing = [](Request&) {};
  const auto listed = [](Request& request) { request.tolerances = Tolerances::listed; };
  const auto clocks = [](Request& request) {
    request.clocks.smallest_offset = 0.005;
    request.clocks.largest_offset = 0.015;
  };
  // 1 g at the tip segment is a tolerance of its mass: what is left is at most its one standard deviation.
  EXPECT_GT(evidence("added_mass", 1.0, nothing).evidence, 10.0);
  EXPECT_LT(evidence("added_mass", 1.0, listed).evidence, 1.0);
  // 4 ms are less than the clocks may be apart: four runs that agree on it leave at most four times 0.4.
  EXPECT_GT(evidence("measurement_delay", 4.0, listed).evidence, 20.0);
  EXPECT_LT(evidence("measurement_delay", 4.0, clocks).evidence, 2.0);
  // Neither has anything to do with friction.
  EXPECT_GT(evidence("dry_friction", 0.3, listed).evidence, 30.0);
}

// A stop that the finger alone throws itself against lies beyond what friction leaves of its motion.
TEST(LaboratorySet, KnowsWhatIsLeftOfAnEffectBesideAnother) {
  const auto evidence_of_the_first = [](std::vector<std::string> hidden, std::vector<double> values) {
    Request request{.hidden = std::move(hidden), .seed = 12, .programme = Programme::few};
    request.values = std::move(values);
    return make_laboratory_set(request).answer.common.hidden.front().evidence;
  };
  constexpr double stop = -2.0;  // deg
  EXPECT_GT(evidence_of_the_first({"end_stop"}, {stop}), 100.0);
  EXPECT_LT(evidence_of_the_first({"end_stop", "dry_friction"}, {stop, 0.8}), 1.0);
}

TEST(LaboratorySet, IsTheSameForTheSameRequestAndTellsNobody) {
  Request request{.hidden = {"hysteresis"}, .seed = 5, .programme = Programme::few};
  request.camera.jitter = 1e-4;
  request.noise.outliers = 0.02;
  const LaboratorySet first = make_laboratory_set(request);
  const LaboratorySet second = make_laboratory_set(request);
  for (std::size_t i = 0; i < first.runs.size(); ++i) EXPECT_EQ(first.runs[i].angles_deg, second.runs[i].angles_deg);
  const coilwright::testing::TemporaryFolder folder;
  write_laboratory_set(first, folder.path() / "set");
  write_answer(first, folder.path() / "answer.json");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "set"))
    EXPECT_EQ(text_of(entry.path()).find("hysteresis"), std::string::npos);
  const auto answer = nlohmann::json::parse(text_of(folder.path() / "answer.json"));
  EXPECT_EQ(answer.at("effects").at(0).at("id"), "hysteresis");
  EXPECT_EQ(answer.at("runs").size(), first.runs.size());
  EXPECT_EQ(answer.at("numbers").size(), 8u);
}

}  // namespace
}  // namespace truth::laboratory
