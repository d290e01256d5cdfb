#include "truth/laboratory/laboratory_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "degree.hpp"
#include "truth/hide.hpp"
#include "truth/laboratory/absorption.hpp"
#include "truth/laboratory/recorder.hpp"
#include "truth/laboratory/run_keys.hpp"

namespace truth::laboratory {
namespace {

constexpr double still_duration = 15.0;  // s

// Faces of soft silicone, which a release of the straight finger presses by a few degrees.
constexpr Faces usual_faces{.angle = 4.0 * degree, .stiffness = 0.12, .damping = 4e-4};
constexpr double misplaced = 3.0 * degree;

void check(const Request& request) {
  const CameraFaults& camera = request.camera;
  const auto require = [](bool holds, const char* rule, double value) {
    if (!holds) throw std::invalid_argument(fmt::format("laboratory: {}; got {:g}", rule, value));
  };
  require(camera.frame_rate > 0.0, "frame rate must be > 0", camera.frame_rate);
  require(camera.exposure_share >= 0.0 && camera.exposure_share <= 0.9, "exposure share must be 0 to 0.9",
          camera.exposure_share);
  require(camera.jitter >= 0.0 && camera.jitter * camera.frame_rate <= 0.1,
          "jitter must be 0 to a tenth of the time between pictures", camera.jitter);
  require(request.clocks.own_rate > 0.0, "own rate of the input must be > 0", request.clocks.own_rate);
  require(request.values.empty() || request.values.size() == request.hidden.size(),
          "values must be none or one for each hidden effect", static_cast<double>(request.values.size()));
}

// A camera that runs at the driver's rate, started with it, sees every edge.
Edges edges_of(const Request& request) {
  const bool aligned = request.clocks.log == InputLog::beside_pictures && request.camera.frame_rate == 500.0;
  return aligned ? Edges::on_updates : Edges::anywhere;
}

}  // namespace

LaboratorySet make_laboratory_set(const Request& request) {
  check(request);
  Random random(request.seed);
  LaboratorySet set;
  set.request = request;
  set.answer.built = build_finger(random, request.deviation, request.tolerances);
  BuiltFinger& built = set.answer.built;
  if (request.faces != DeclaredFaces::none) set.answer.declared_faces = usual_faces;
  if (request.faces == DeclaredFaces::elsewhere) {
    built.finger.faces = usual_faces;
    built.finger.faces.angle += random.sign() * misplaced;
  }
  set.answer.common = {.seed = request.seed,
                       .hidden = {},
                       .joint_stiffness = built.finger.stiffness,
                       .joint_damping = built.finger.damping,
                       .noise = request.noise.level,
                       .resolution = resolution_deg * degree};

  const bool shorted = std::find(request.hidden.begin(), request.hidden.end(), "back_emf") != request.hidden.end();
  std::vector<PlannedRun> planned = plan_runs(request.programme, edges_of(request), shorted, random);
  // What is declared of an input between its samples is true of it.
  for (PlannedRun& run : planned)
    if (hold_of(request, run) == "linear") run = drawn_through(run, input_times_of(request, run));
  Recorder recorder(request, random);
  std::vector<Recorder::Session> sessions;
  std::vector<Experiment> fit;
  for (const PlannedRun& run : planned) {
    sessions.push_back(recorder.open_session(run));
    if (run.validate) continue;
    fit.push_back(run.experiment);
    for (const double middle : sessions.back().middles) fit.back().seen.push_back(std::max(middle, 0.0));
  }

  UnmodelledEffects all;
  all.chance = random.seed();
  if (!request.hidden.empty()) {
    const HidingPlace place(request.channels, built.finger, fit, request.noise.level);
    std::vector<UnmodelledEffects> each;
    for (std::size_t i = 0; i < request.hidden.size(); ++i) {
      UnmodelledEffects& alone = each.emplace_back();
      alone.chance = all.chance;
      HiddenEffect effect =
          hide(place,
               {.name = request.hidden[i],
                .weakest = request.weakest,
                .strongest = request.strongest,
                .at_bound = request.at_bound,
                .value = request.values.empty() ? std::nullopt : std::optional<double>(request.values[i]),
                .find_confounders = request.find_confounders && request.hidden.size() == 1},
               random, alone);
      add_effect(hidden_kind(request.hidden[i]), alone, all);
      set.answer.common.hidden.push_back(std::move(effect));
    }
    // Beside the others: a finger with friction may never reach the stop that it meets without.
    const RecordedAngles together = recorded_angles(request.channels, built.finger, all, fit);
    for (std::size_t i = 0; i < each.size(); ++i) {
      UnmodelledEffects others;
      others.chance = all.chance;
      for (std::size_t k = 0; k < each.size(); ++k)
        if (k != i) add_effect(hidden_kind(request.hidden[k]), each[k], others);
      const Absorption absorption({.request = request,
                                   .built = built,
                                   .others = others,
                                   .planned = planned,
                                   .fit = fit,
                                   .without = recorded_angles(request.channels, built.finger, others, fit),
                                   .noise = request.noise.level});
      set.answer.common.hidden[i].evidence = absorption.left_of(together);
    }
  }
  all.angle_scale *= built.angle_scale;

  for (std::size_t i = 0; i < planned.size(); ++i)
    set.runs.push_back(recorder.record(planned[i], sessions[i], built.finger, all));
  if (request.noise.still_run) set.still = recorder.record_still(built.finger, all, still_duration);
  return set;
}

}  // namespace truth::laboratory
