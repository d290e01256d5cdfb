#include "coilwright/formats/data/plan_json.hpp"

#include <stdexcept>
#include <string_view>
#include <utility>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement::experiment;
using actuator::Effect;
using measurement::data::Drive;

Json parameters_json(const Effect& effect) {
  Json out = Json::object();
  for (std::size_t i = 0; i < effect.values.size(); ++i) {
    const std::string_view key = effect.kind->parameters()[i].key;
    out.set(std::string(key), units::from_memory(effect.values[i], key));
  }
  return out;
}

Json effect_json(const VisibleEffect& effect) {
  Json out =
      Json::object({{"id", effect.effect.kind->id()},
                    {"visible", effect.visible},
                    {"strength", effect.main ? Json(effect.effect.kind->parameters()[*effect.main].key) : Json()},
                    {effect.visible ? "smallest" : "strongest_tried", parameters_json(effect.effect)},
                    {"change_over_limit", effect.over_limit}});
  if (!effect.visible) out.set("remark", effect.remark);
  return out;
}

// A level under its name with the unit of the drive: "after_A".
class Shape {
 public:
  explicit Shape(Drive drive) : suffix_(drive == Drive::torque ? "_Nmm" : drive == Drive::voltage ? "_V" : "_A") {}

  Json operator()(const StepShape& step) const {
    return one("step", {level("before", step.before), level("after", step.after), {"at_s", step.at}});
  }
  Json operator()(const HoldShape& hold) const {
    return one("hold", {level("level", hold.level), {"from_s", hold.from}, {"until_s", hold.until}});
  }
  Json operator()(const SineShape& sine) const {
    return one("sine",
               {level("amplitude", sine.amplitude), level("offset", sine.offset), {"frequency_Hz", sine.frequency}});
  }
  Json operator()(const ChirpShape& chirp) const {
    return one("chirp", {level("amplitude", chirp.amplitude),
                         level("offset", chirp.offset),
                         {"from_Hz", chirp.from},
                         {"to_Hz", chirp.to}});
  }
  Json operator()(const PulseShape& pulse) const {
    return one("pulses",
               {level("low", pulse.low), level("high", pulse.high), {"period_s", pulse.period}, {"duty", pulse.duty}});
  }
  Json operator()(const TableShape& /*table*/) const {
    throw std::invalid_argument("an input from a file has no keys of its own");
  }

 private:
  [[nodiscard]] Json::Member level(std::string name, double value) const {
    name += suffix_;
    const double in_unit = units::from_si(value, name);
    return {std::move(name), in_unit};
  }
  static Json one(const char* shape, std::vector<Json::Member> members) {
    return Json::object({{shape, Json::object(std::move(members))}});
  }

  std::string suffix_;
};

const char* word_of(Drive drive) {
  return drive == Drive::torque ? "torque" : drive == Drive::voltage ? "voltage" : "current";
}

Json added_run_json(const AddedRun& run) {
  return Json::object({{"kind", run.kind},
                       {"input", run.input},
                       {"why", run.why},
                       {"smallest_strengths_ratio", run.lowering},
                       {"newly_visible", run.newly_visible},
                       {"separated_pairs", run.separated_pairs},
                       {"run", run_json(run.run)}});
}

}  // namespace

Json run_json(const PlannedRun& run) {
  const measurement::data::Run& plan = run.plan;
  Json measure = Json::array();
  for (const measurement::data::Channel& channel : plan.channels) measure.add(channel.name);
  Json out = Json::object({{"file", plan.name},
                           {"role", run.validate ? "validate" : "fit"},
                           {"duration_s", run.duration},
                           {"sampling_rate_Hz", run.rate},
                           {"measure", std::move(measure)},
                           {"input", std::visit(Shape(plan.drive), run.input)}});
  if (plan.drive != Drive::current) out.set("drive", word_of(plan.drive));
  if (run.only) out.set(plan.drive == Drive::torque ? "joint" : "coil", *run.only + 1);
  if (plan.rig == measurement::data::RigChange{}) return out;
  Json rig = Json::object();
  if (plan.rig.base_turn != 0.0) rig.set("base_turn_deg", units::from_si(plan.rig.base_turn, "base_turn_deg"));
  if (plan.rig.tip_mass > 0.0) rig.set("tip_mass_g", units::from_si(plan.rig.tip_mass, "tip_mass_g"));
  if (plan.rig.coil != measurement::data::CoilWiring::driven) rig.set("coil", name_of(plan.rig.coil));
  out.set("rig", std::move(rig));
  return out;
}

Json to_json(const PlanReport& report) {
  const ExperimentPlan& plan = report.plan;
  Json effects = Json::array();
  for (const VisibleEffect& effect : plan.effects) effects.add(effect_json(effect));
  Json left_out = Json::array();
  for (const LeftOutEffect& effect : plan.left_out)
    left_out.add(Json::object({{"id", effect.kind->id()}, {"reason", effect.reason}}));
  Json pairs = Json::array();
  for (const InseparablePair& pair : plan.pairs)
    pairs.add(Json::object({{"effects", Json::array({plan.effects[pair.first].effect.kind->id(),
                                                     plan.effects[pair.second].effect.kind->id()})},
                            {"cosine", pair.cosine},
                            {"difference_over_limit", pair.over_limit}}));
  Json added = Json::array();
  for (const AddedRun& run : plan.added_runs) added.add(added_run_json(run));
  Json exact = Json::array();
  for (const std::string& name : plan.held_exact) exact.add(name);
  return Json::object({{"format", "experiment-plan/1"},
                       {"experiment", report.experiment},
                       {"actuator", report.actuator},
                       {"samples", plan.samples},
                       {"overdispersion", plan.overdispersion},
                       {"effects", std::move(effects)},
                       {"left_out", std::move(left_out)},
                       {"inseparable_pairs", std::move(pairs)},
                       {"added_runs", std::move(added)},
                       {"held_exact", std::move(exact)},
                       {"simulated_runs", plan.simulated_runs}});
}

}  // namespace coilwright::formats
