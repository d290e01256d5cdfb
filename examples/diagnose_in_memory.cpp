// A swinging link does not move as its model says. Which effect does the model lack, if the records are in memory?
//
// Build  cmake --preset release && cmake --build --preset release --target example_diagnose_in_memory
// Run    build/release/examples/diagnose_in_memory
// Prints the verdict, the effect with its fitted number and its interval, and the error on the run that no fit has
// seen.

#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <span>
#include <string>

#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/measurement/replay/declare.hpp"
#include "coilwright/units/unit.hpp"

namespace {

using namespace coilwright;
using namespace coilwright::measurement;

constexpr double degrees = 57.29577951308232;

// The link, a pendulum with a spring and a damper: what we believe.
constexpr mechanics::Link link{.length = 0.04, .com_along = 0.02, .com_offset = 0.0, .mass = 0.03, .inertia = 4e-6};
constexpr actuator::Hinge hinge{.stiffness = 0.012, .damping = 8e-5};

actuator::ModelSpec believed() {
  return {.chain = mechanics::PlanarChain(std::span(&link, 1)),
          .hinges = {hinge},
          .magnetics = {},
          .coils = 0,
          .tip = {.link = 0, .along = link.length}};
}

// In place of a logger: the link under a torque that is switched every quarter of a second, with a payload of 8 g that
// we do not know of.
data::Run recorded(const std::string& name, double torque, unsigned seed) {
  constexpr double interval = 0.005, gravity = 9.81, payload = 0.008, noise = 0.002;  // s, m/s^2, kg, rad
  const double moment = (link.mass + payload) * link.com_along;
  const double inertia = link.inertia + moment * link.com_along;
  data::Run run{.name = name,
                .kind = data::RunKind::transient,
                .drive = data::Drive::torque,
                .sigma = noise,
                .channels = {{.name = "theta1_rad", .kind = data::ChannelKind::joint_angle}}};
  std::mt19937 random(seed);
  double angle = 0.0, rate = 0.0;
  for (int sample = 0; sample < 200; ++sample) {
    const double applied = sample / 50 % 2 == 1 ? torque : 0.0;
    run.times.push_back(interval * sample);
    run.inputs.push_back({applied});
    double error = -6.0;  // of twelve uniform numbers: nearly normal, and the same everywhere
    for (int i = 0; i < 12; ++i) error += static_cast<double>(random()) / 4294967296.0;
    run.channels.front().values.push_back(angle + noise * error);
    constexpr int steps = 500;
    for (int step = 0; step < steps; ++step) {
      rate += interval / steps *
              (applied - hinge.stiffness * angle - hinge.damping * rate - gravity * moment * std::sin(angle)) / inertia;
      angle += interval / steps * rate;
    }
  }
  return run;
}

}  // namespace

int main() {
  try {
    data::Dataset set;
    set.fit = {recorded("push", 4e-3, 1), recorded("pull", -6e-3, 2)};
    set.validate = data::SealedRuns({recorded("held out", 5e-3, 3)});
    const Diagnosis diagnosis = diagnose(set, replay::declare(believed()));

    std::printf("verdict: %s\n", std::string(name_of(diagnosis.verdict)).c_str());
    for (const AddedEffect& effect : diagnosis.effects)
      for (const identification::Estimate& number : effect.parameters)
        std::printf("%s: %s %.2f, 95 %% of %.2f to %.2f\n", std::string(effect.kind->id()).c_str(), number.key.c_str(),
                    units::from_memory(number.value, number.key), units::from_memory(number.lower, number.key),
                    units::from_memory(number.upper, number.key));
    const ErrorComparison& errors = diagnosis.validate_errors.front();
    std::printf("rms error of the run held out: as declared %.2f deg, corrected %.2f deg\n",
                errors.declared.rmse * degrees, errors.after.rmse * degrees);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
