// Simulation-based calibration of the posterior (Talts, Betancourt, Simpson, Vehtari and Gelman 2018): stiffness,
// damping and the numbers of an effect are drawn from the priors of a fit, a record is made with them, the hypothesis
// that is true is fitted, and the rank of each true number in its posterior is taken. Of a posterior that is what it
// says all ranks are equally frequent.
//
// An effect too weak to be told from none leaves the posterior at its prior, which Laplace's approximation about a fit
// does not know: draws count where the true number is five or more of its standard deviations, by the curvature at the
// truth, from the value at which the effect is absent. That depends on what was drawn, and on no noise.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glog/logging.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/formats/data/experiment_file.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "measurement/identification/curvature.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/identification/weighed_fit.hpp"
#include "measurement/replay/recorded_noise.hpp"
#include "run_program.hpp"
#include "truth/random.hpp"

namespace {

using namespace coilwright;
using namespace coilwright::measurement;
using actuator::Effect;
using actuator::EffectKind;
using actuator::EffectParameter;
using truth::Random;

constexpr std::size_t bins = 10;
constexpr double least_deviations = 5.0;  // of an effect that is seen
constexpr double largest_factor = 100.0;  // of a magnitude over a typical one: beyond two deviations rigs break
using Ranks = std::array<int, bins>;

// Student's t with 4 degrees of freedom, of a normal number and of four more.
double heavy_tailed(Random& random) {
  const double normal = random.normal();
  double squares = 0.0;
  for (int i = 0; i < 4; ++i) squares += std::pow(random.normal(), 2);
  return normal / std::sqrt(squares / 4.0);
}

// The inverse of what identification::prior_of_numbers() says of one number.
double drawn(const EffectKind& kind, std::size_t index, const actuator::RigScale& scale, Random& random) {
  const EffectParameter& number = kind.parameters()[index];
  if (!number.choices.empty())
    return number.choices[static_cast<std::size_t>(random.below(static_cast<int>(number.choices.size())))];
  const bool has_origin = number.absent && std::isfinite(*number.absent);
  if (!has_origin && std::isfinite(number.lower) && std::isfinite(number.upper) && number.lower < 0.0)
    return random.uniform(number.lower, number.upper);
  const double origin = has_origin ? *number.absent : 0.0;
  double sum = 0.0;
  int count = 0;
  for (const std::vector<double>& start : kind.starts(scale)) {
    if (start[index] == origin) continue;
    sum += std::log(std::abs(start[index] - origin));
    ++count;
  }
  const double typical = count == 0 ? 1.0 : std::exp(sum / count);
  double u = random.normal();
  while (std::abs(u) > std::log10(largest_factor)) u = random.normal();
  const double magnitude = typical * std::pow(10.0, u);
  if (!has_origin) return magnitude;
  if (number.lower < origin && origin < number.upper) return origin + random.sign() * magnitude;
  return number.lower < origin ? origin - magnitude : origin + magnitude;
}

actuator::Model nominal_model(const replay::DeclaredModel& declared) {
  const fit::Hypothesis plain(declared, {});
  return plain.model_at(plain.start());
}

std::vector<replay::PreparedRun> prepared(const std::vector<data::Run>& records,
                                          const replay::DeclaredModel& declared) {
  const actuator::Model nominal = nominal_model(declared);
  std::vector<replay::PreparedRun> runs;
  for (const data::Run& run : records) {
    runs.push_back(replay::prepare_run(run, declared, nominal));
    replay::give_recorded_noise(runs.back(), {}, records);
  }
  return runs;
}

// Joints that bend both ways, slowly and quickly.
constexpr const char* experiment_text = R"({{"format": "experiment/1", "name": "calibration", "sampling_rate_Hz": 200,
  "noise": {{"angle_deg": 0.1}}, "measure": [{}], "runs": [
  {{"file": "up.csv", "role": "fit", "duration_s": 1.5, "drive": "current",
   "input": {{"step": {{"after_A": 0.5, "at_s": 0.1}}}}}},
  {{"file": "down.csv", "role": "fit", "duration_s": 1.5, "drive": "current",
   "input": {{"step": {{"after_A": -0.4, "at_s": 0.1}}}}}},
  {{"file": "slow.csv", "role": "fit", "duration_s": 2, "drive": "current",
   "input": {{"sine": {{"amplitude_A": 0.45, "frequency_Hz": 1}}}}}},
  {{"file": "quick.csv", "role": "fit", "duration_s": 1.5, "drive": "current",
   "input": {{"sine": {{"amplitude_A": 0.3, "frequency_Hz": 3}}}}}}]}})";
constexpr const char* model_text = R"({{"format": "lumped-model/1", "gravity_m_s2": 9.81, "links": [{}], "joints": [{}],
  "magnetics": [{}]}})";
constexpr const char* link_text =
    R"({"length_m": 0.04, "com_along_m": 0.02, "com_offset_m": 0.001, "mass_kg": 0.03, "inertia_kgm2": 4e-6})";
constexpr const char* joint_text = R"({"stiffness_Nm_rad": 0.0125, "damping_Nms_rad": 1.29e-4})";
constexpr const char* pair_text = R"({"angle_deg": [-120, -50, 0, 50, 120], "torque_Nmm_A": [7, 14, 17, 13, 6]})";

// A few like joints, of which the first one's stiffness and damping are known to a tolerance.
struct Rig {
  replay::DeclaredModel declared;
  planning::Experiment experiment;
  actuator::RigScale scale;
};

Rig rig_of(int joints) {
  const auto each = [joints](const char* text) {
    return fmt::format("{}", fmt::join(std::vector(static_cast<std::size_t>(joints), text), ", "));
  };
  Rig out{
      .declared =
          formats::parse_declared_actuator(
              fmt::format(model_text, each(link_text), each(joint_text), each(pair_text)), "joints.json",
              {.names = {},
               .file = "calibration",
               .tolerances = {.others_exact = true,
                              .named = {{"/joints/0/stiffness_Nm_rad", 0.0006}, {"/joints/0/damping_Nms_rad", 1e-5}}}})
              .model,
      .experiment = formats::parse_experiment(
          fmt::format(experiment_text, joints == 1 ? R"("theta1_deg")" : R"("theta1_deg", "theta2_deg")"),
          "experiment.json"),
      .scale = {}};
  const std::vector<data::Run> as_declared = planning::simulate_experiment(out.experiment, out.declared, {}, 1);
  out.scale = identification::rig_scale(prepared(as_declared, out.declared), nominal_model(out.declared));
  return out;
}

bool can_have(const Rig& rig, const EffectKind& kind) {
  return !kind.inapplicable(nominal_model(rig.declared).nominal_spec());
}

struct Truth {
  std::vector<double> declared{};  // stiffness, damping
  Effect effect{};
};

Truth drawn_truth(const EffectKind& kind, const Rig& rig, Random& random) {
  Truth out{.declared = {}, .effect = {.kind = &kind, .values = {}}};
  for (const replay::CalibrationParameter& number : rig.declared.calibration) {
    double value = number.lower;
    while (!(value > number.lower && value < number.upper))
      value = number.declared + number.tolerance->deviation * heavy_tailed(random);
    out.declared.push_back(value);
  }
  for (std::size_t i = 0; i < kind.parameters().size(); ++i)
    out.effect.values.push_back(drawn(kind, i, rig.scale, random));
  return out;
}

// The first number that is fitted; one past the last where none is.
std::size_t main_number(const EffectKind& kind) {
  const auto numbers = kind.parameters();
  return static_cast<std::size_t>(
      std::ranges::find_if(numbers, [](const EffectParameter& each) { return each.choices.empty(); }) -
      numbers.begin());
}

// How many of its deviations a true number lies above the mode, by the coordinate in which its prior is simple.
double deviations_above(double truth, double mode, double deviation, const EffectParameter* number) {
  const bool has_origin = number != nullptr && number->absent && std::isfinite(*number->absent);
  const double origin = has_origin ? *number->absent : 0.0;
  const bool is_magnitude = has_origin || (number != nullptr && number->lower >= 0.0);
  const double ratio = (truth - origin) / (mode - origin);
  if (!is_magnitude || !(ratio > 0.0)) return (truth - mode) / deviation;
  return std::log(ratio) * (mode - origin) / deviation;
}

enum class Outcome { impossible, unseen, counted };

struct Calibrated {
  Outcome outcome{};
  std::vector<double> deviations{};  // stiffness, damping, the effect's number
};

Calibrated calibrated(const Truth& truth, const Rig& rig, std::uint64_t seed) {
  replay::DeclaredModel true_rig = rig.declared;
  for (std::size_t i = 0; i < true_rig.calibration.size(); ++i) true_rig.calibration[i].declared = truth.declared[i];
  std::vector<data::Run> records;
  try {
    records = planning::simulate_experiment(rig.experiment, true_rig, std::span(&truth.effect, 1), seed);
  } catch (const std::exception&) {
    return {};
  }
  const std::vector<replay::PreparedRun> runs = prepared(records, rig.declared);
  const fit::Hypothesis hypothesis(rig.declared, {truth.effect});
  Eigen::VectorXd start = hypothesis.start();
  for (std::size_t i = 0; i < truth.declared.size(); ++i) start[static_cast<Eigen::Index>(i)] = truth.declared[i];
  const auto there = fit::evaluate_with_jacobian(
      {.hypothesis = &hypothesis, .runs = runs, .start = start, .effort = {.iterations = 0}});
  if (!there || start != hypothesis.clamped(start)) return {};
  const std::size_t main = main_number(*truth.effect.kind);
  const EffectParameter& number = truth.effect.kind->parameters()[main];
  const Eigen::Index place = hypothesis.parameters_of(0).first;
  const double origin = number.absent && std::isfinite(*number.absent) ? *number.absent : 0.0;
  const double precise =
      identification::standard_deviations(identification::score(runs, hypothesis, *there), 1.0)[place];
  if (!(std::abs(truth.effect.values[main] - origin) > least_deviations * precise)) return {.outcome = Outcome::unseen};
  const auto fitted = identification::fit_exactly(runs, {.hypothesis = hypothesis, .start = start});
  if (!fitted) return {};
  const identification::WeighedFit posterior = identification::weighed(runs, *fitted, rig.scale);
  Calibrated out{.outcome = Outcome::counted};
  for (Eigen::Index i = 0; i <= place; ++i) {
    if (i >= std::ssize(truth.declared) && i != place) continue;
    out.deviations.push_back(deviations_above(i == place ? truth.effect.values[main] : start[i], posterior.values[i],
                                              std::sqrt(posterior.covariance(i, i)), i == place ? &number : nullptr));
  }
  return out;
}

// The ranks of one number.
class Ranked {
 public:
  void add(double deviations) {
    const double below = std::isfinite(deviations) ? boost::math::cdf(boost::math::normal(), deviations) : 0.0;
    ++ranks_[std::min(bins - 1, static_cast<std::size_t>(below * bins))];
    deviations_.push_back(deviations);
  }
  [[nodiscard]] std::string line(const std::string& name) const {
    const auto count = static_cast<double>(deviations_.size());
    double chi_square = 0.0, sum = 0.0;
    for (const int each : ranks_) chi_square += std::pow(each - count / bins, 2) / (count / bins);
    for (const double each : deviations_) sum += each;
    std::vector<double> sizes;
    for (const double each : deviations_) sizes.push_back(std::abs(each));
    std::ranges::sort(sizes);
    const auto inside = std::ranges::count_if(sizes, [](double each) { return each < 1.96; });
    // Of normal deviates half lie within 0.6745.
    return fmt::format("{:24} {:5}  {:6.1f}  {:8.2g}  {:5.1f} %  {:6.2f}  {:5.2f}  {}\n", name, deviations_.size(),
                       chi_square,
                       boost::math::cdf(boost::math::complement(boost::math::chi_squared(bins - 1), chi_square)),
                       100.0 * static_cast<double>(inside) / count, sum / count, sizes[sizes.size() / 2] / 0.6745,
                       fmt::join(ranks_, " "));
  }
  [[nodiscard]] bool any() const { return !deviations_.empty(); }

 private:
  Ranks ranks_{};
  std::vector<double> deviations_;
};

int run(int argc, char** argv) {
  CLI::App app("Whether posteriors of the hypothesis that is true are as wide as they say", "calibration_benchmark");
  int draws = 40;
  std::uint64_t seed = 1;
  std::vector<std::string> only;
  app.add_option("--draws", draws, "Draws of each effect in which it is seen")->capture_default_str();
  app.add_option("--seed", seed, "Of the draws")->capture_default_str();
  app.add_option("--effect", only, "Only this effect; may be repeated");
  CLI11_PARSE(app, argc, argv);
  FLAGS_minloglevel = google::GLOG_FATAL;  // a rig that cannot be simulated is no news

  const std::array rigs = {rig_of(1), rig_of(2)};
  Ranked stiffness, damping;
  std::string lines, left_out;
  constexpr int most_tries = 10;  // of each draw
  Random seeds(seed);
  for (const EffectKind* kind : actuator::standard_effects().kinds()) {
    // Each effect has draws of its own: stiffness and damping are ranked over all of them.
    Random random(seeds.seed());
    if (!only.empty() && std::ranges::find(only, kind->id()) == only.end()) continue;
    const auto rig = std::ranges::find_if(rigs, [&](const Rig& each) { return can_have(each, *kind); });
    if (rig == rigs.end() || main_number(*kind) == kind->parameters().size()) continue;
    Ranked ranked;
    std::map<Outcome, int> counts;
    for (int tried = 0; counts[Outcome::counted] < draws && tried < most_tries * draws; ++tried) {
      if (tried == 3 * most_tries && counts[Outcome::counted] == 0) break;
      const Truth truth = drawn_truth(*kind, *rig, random);
      const Calibrated found = calibrated(truth, *rig, random.seed());
      ++counts[found.outcome];
      if (found.outcome != Outcome::counted) continue;
      stiffness.add(found.deviations[0]);
      damping.add(found.deviations[1]);
      ranked.add(found.deviations[2]);
    }
    if (ranked.any()) lines += ranked.line(std::string(kind->id()));
    left_out += fmt::format("{:24} {:5} {:6} {:6}\n", kind->id(), counts[Outcome::counted], counts[Outcome::unseen],
                            counts[Outcome::impossible]);
    fmt::print(stderr, "{}: {}\n", kind->id(), counts[Outcome::counted]);
  }
  if (!stiffness.any()) throw std::invalid_argument("no draw counts; a larger --draws tries more often");
  fmt::print("{:24} draws  chi-sq.  p        in 95 %  mean  width  ranks in {} bins\n{}{}{}", "number", bins,
             stiffness.line("stiffness"), damping.line("damping"), lines);
  fmt::print(
      "\nmean: of (truth - mode) / deviation; width: its size, 1 where the deviation is right\n\n"
      "{:24} seen  unseen  no motion\n{}",
      "draws", left_out);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("calibration_benchmark", [&] { return run(argc, argv); });
}
