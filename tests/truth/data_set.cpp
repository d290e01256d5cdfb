#include "truth/data_set.hpp"

#include <cmath>

#include "degree.hpp"
#include "truth/hide.hpp"
#include "truth/random.hpp"
#include "truth/recording.hpp"

namespace truth {
namespace {

constexpr double noise = 0.3 * degree;
constexpr double resolution_deg = 0.02;

}  // namespace

DataSet make_data_set(const DataSetRequest& request) {
  Random random(request.seed);
  DataSet set{.request = request, .answer = {}, .runs = {}};
  Finger finger;
  // The true values differ from those of Table II by a few per cent.
  finger.stiffness *= 1.0 + random.sign() * random.uniform(0.02, 0.08);
  finger.damping *= 1.0 + random.sign() * random.uniform(0.03, 0.12);
  set.answer = {.seed = request.seed,
                .hidden = {},
                .joint_stiffness = finger.stiffness,
                .joint_damping = finger.damping,
                .noise = noise,
                .resolution = resolution_deg * degree};

  const PlannedRuns planned = request.programme == Programme::brief ? brief_runs() : paper_runs();
  UnmodelledEffects all;
  all.chance = random.seed();
  if (!request.hidden.empty()) {
    const HidingPlace place(request.camera, finger, planned.fit, noise);
    for (const std::string& name : request.hidden)
      set.answer.hidden.push_back(hide(place,
                                       {.name = name,
                                        .weakest = request.weakest,
                                        .strongest = request.strongest,
                                        .find_confounders = request.find_confounders && request.hidden.size() == 1},
                                       random, all));
  }

  const auto record_run = [&](const Experiment& experiment, bool validate) {
    Random camera_noise(random.seed());
    const Eigen::VectorXd seen = camera_view(request.camera, all, experiment, simulate(finger, all, experiment));
    RecordedRun recorded{.experiment = experiment, .validate = validate, .angles_deg = {}};
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < experiment.times.size(); ++i) {
      std::vector<double>& row = recorded.angles_deg.emplace_back();
      for (int c = 0; c < channel_count(request.camera); ++c) {
        const double angle_deg = (seen[at++] + noise * camera_noise.normal()) / degree;
        row.push_back(std::round(angle_deg / resolution_deg) * resolution_deg);
      }
    }
    set.runs.push_back(std::move(recorded));
  };
  for (const Experiment& experiment : planned.fit) record_run(experiment, false);
  for (const Experiment& experiment : planned.validate) record_run(experiment, true);
  return set;
}

}  // namespace truth
