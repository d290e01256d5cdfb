#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>

#include "actuator/effects/rig.hpp"
#include "coilwright/actuator/model/model.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

// measured-data/1, "Effect ids".
const std::set<std::string> ids_of_the_format = {
    "dry_friction",     "quadratic_drag",    "viscoelastic_creep", "hysteresis",        "stiffness_hardening",
    "joint_asymmetry",  "rest_angle",        "end_stop",           "base_tilt",         "added_mass",
    "force_gain",       "coil_lag",          "back_emf",           "coil_heating",      "magnet_heating",
    "current_offset",   "angle_scale",       "driver_saturation",  "static_attraction", "measurement_delay",
    "driver_deadband",  "angle_offset",      "off_axis_force",     "coil_coil_force",   "backlash",
    "mount_compliance", "mullins_softening", "tracking_lag",       "load_friction",     "rotor_inertia"};

// A 70 g finger, and a 95 kg axis written as a link of unit length.
RigScale finger_scale() {
  return {.torque = 8e-3,
          .angle = 0.4,
          .rate = 7.0,
          .current = 1.4,
          .interval = 2e-3,
          .duration = 2.0,
          .mean_angle = 0.45,
          .upper_angle = 0.9,
          .lower_angle = 0.1};
}
RigScale axis_scale() {
  return {.torque = 60.0,
          .angle = 0.08,
          .rate = 0.25,
          .current = 0.04,
          .interval = 1e-3,
          .duration = 24.8,
          .mean_angle = 0.12,
          .upper_angle = 0.24,
          .lower_angle = -0.01};
}

bool is_absent(const EffectKind& kind, const Numbers& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (kind.parameters()[i].absent == values[i]) return true;
  return false;
}

// Everything that an effect can change, at a pose in motion.
struct Answer {
  CoilCurrents currents;
  CoilCurrents strength;
  JointVector torques;
  mechanics::JointMatrix damping;
  Numbers slopes;
  Numbers bodies;
  JointVector shown;
  double observed{};
  double delay{};
};

Answer answer_of(const EffectTerm* term, const ModelSpec& spec, const Numbers& states, double rate) {
  const int n = spec.chain.joints();
  JointVector angles(n);
  JointVector rates(n);
  for (int j = 0; j < n; ++j) angles[j] = 0.3 - 0.2 * j, rates[j] = rate * (1.0 - 0.7 * j);
  CoilCurrents currents(spec.coils);
  for (int c = 0; c < spec.coils; ++c) currents[c] = 0.83 - 1.4 * c;
  Answer a{.currents = currents,
           .strength = currents,
           .torques = JointVector::Zero(n),
           .damping = mechanics::JointMatrix::Zero(n, n),
           .slopes = Numbers(states.size(), 0.0),
           .bodies = {},
           .shown = angles,
           .observed = 0.37};
  if (term == nullptr) return a;
  const EffectTerm::InternalStateView own{.states = states.data(), .slopes = a.slopes.data()};
  const EffectTerm::Kinematics motion{.chain = spec.chain, .angles = angles, .rates = rates};
  term->drive(own, a.currents);
  a.strength = a.currents;
  term->magnetize(own, a.currents, a.strength);
  term->add_torques(motion, a.strength, own, a.torques);
  term->add_damping(motion, a.strength, a.damping);
  std::vector<EffectTerm::Body> bodies(term->bodies(), {.coupling = JointVector::Zero(n)});
  term->describe_bodies(motion, a.strength, states.data(), bodies.data());
  for (const EffectTerm::Body& body : bodies)
    for (const double number : {body.coupling.sum(), body.mass, body.force}) a.bodies.push_back(number);
  term->show(own, a.shown, rates);
  a.observed = term->observed(a.observed);
  a.delay = term->delay();
  return a;
}

bool finite(const Answer& a) {
  bool all = a.currents.allFinite() && a.strength.allFinite() && a.torques.allFinite() && a.damping.allFinite() &&
             a.shown.allFinite() && std::isfinite(a.observed) && std::isfinite(a.delay);
  for (const double slope : a.slopes) all = all && std::isfinite(slope);
  for (const double number : a.bodies) all = all && std::isfinite(number);
  return all;
}

void expect_same_spec(const ModelSpec& a, const ModelSpec& b) {
  EXPECT_EQ(a.chain.gravity(), b.chain.gravity());
  EXPECT_EQ(a.chain.base_tilt(), b.chain.base_tilt());
  for (int j = 0; j < a.chain.joints(); ++j) {
    EXPECT_EQ(a.chain.link(j).mass, b.chain.link(j).mass);
    EXPECT_EQ(a.chain.link(j).com_along, b.chain.link(j).com_along);
    EXPECT_EQ(a.chain.link(j).inertia, b.chain.link(j).inertia);
    EXPECT_EQ(a.chain.link(j).rotor_inertia, b.chain.link(j).rotor_inertia);
    EXPECT_EQ(a.hinges[j].stiffness, b.hinges[j].stiffness);
    EXPECT_EQ(a.hinges[j].damping, b.hinges[j].damping);
    EXPECT_EQ(a.hinges[j].torque_offset, b.hinges[j].torque_offset);
  }
}

TEST(StandardEffects, HasTheIdsOfTheFormatOnce) {
  std::set<std::string> ids;
  for (const EffectKind* kind : standard_effects().kinds()) EXPECT_TRUE(ids.emplace(kind->id()).second) << kind->id();
  EXPECT_EQ(ids, ids_of_the_format);
}

TEST(StandardEffects, IsInTheOrderOfTheStages) {
  Stage last = Stage::drive;
  for (const EffectKind* kind : standard_effects().kinds()) {
    EXPECT_GE(static_cast<int>(kind->stage()), static_cast<int>(last)) << kind->id();
    last = kind->stage();
  }
}

TEST(StandardEffects, FindsAnEffectByItsId) {
  for (const EffectKind* kind : standard_effects().kinds()) EXPECT_EQ(standard_effects().find(kind->id()), kind);
  EXPECT_EQ(standard_effects().find("dry_frictio"), nullptr);
  EXPECT_EQ(standard_effects().find(""), nullptr);
}

TEST(StandardEffects, SaysInALineWhatEachIs) {
  for (const EffectKind* kind : standard_effects().kinds()) {
    for (const std::string_view text : {kind->description(), kind->equation(), kind->source(), kind->check()}) {
      EXPECT_FALSE(text.empty()) << kind->id();
      EXPECT_EQ(text.find('\n'), std::string_view::npos) << kind->id();
    }
    std::set<std::string_view> keys;
    for (const EffectParameter& p : kind->parameters()) {
      EXPECT_TRUE(keys.insert(p.key).second) << kind->id() << p.key;
      EXPECT_FALSE(p.text.empty()) << kind->id() << p.key;
      EXPECT_LT(p.lower, p.upper) << kind->id() << p.key;
    }
  }
}

TEST(StandardEffects, StartsInsideTheBoundsAndWithTheEffect) {
  for (const EffectKind* kind : standard_effects().kinds()) {
    for (const RigScale& scale : {finger_scale(), axis_scale()}) {
      const std::vector<Numbers> starts = kind->starts(scale);
      ASSERT_FALSE(starts.empty()) << kind->id();
      EXPECT_EQ(std::set<Numbers>(starts.begin(), starts.end()).size(), starts.size()) << kind->id();
      for (const Numbers& start : starts) {
        EXPECT_EQ(error_text([&] { validate_effect({.kind = kind, .values = start}); }), "");
        EXPECT_FALSE(is_absent(*kind, start)) << kind->id();
      }
    }
  }
}

// A run too short for two samples, a rig that hardly moves: extremes a set of data may have.
TEST(StandardEffects, StartsInsideTheBoundsOnOddRigsToo) {
  RigScale shortest = finger_scale();
  shortest.duration = shortest.interval = 1e-4;
  RigScale longest = axis_scale();
  longest.duration = 3e5;
  longest.interval = 60.0;
  RigScale still = finger_scale();
  still.angle = 1e-5;
  still.rate = 1e-4;
  for (const RigScale& scale : {shortest, longest, still})
    for (const EffectKind* kind : standard_effects().kinds())
      for (const Numbers& start : kind->starts(scale)) {
        EXPECT_EQ(error_text([&] { validate_effect({.kind = kind, .values = start}); }), "");
        EXPECT_FALSE(is_absent(*kind, start)) << kind->id();
      }
}

TEST(StandardEffects, ChangesNothingWhereAnEffectIsAbsent) {
  const ModelSpec nominal = finger();
  for (const EffectKind* kind : standard_effects().kinds()) {
    for (std::size_t i = 0; i < kind->parameters().size(); ++i) {
      if (!kind->parameters()[i].absent) continue;
      Numbers values = kind->starts(finger_scale()).front();
      values[i] = *kind->parameters()[i].absent;
      ModelSpec spec = nominal;
      const std::unique_ptr<const EffectTerm> term = kind->build(values, spec);
      SCOPED_TRACE(std::string(kind->id()));
      expect_same_spec(spec, nominal);
      const Numbers states(term == nullptr ? 0 : term->states(), 0.4);
      const Answer with = answer_of(term.get(), spec, states, 3.0);
      const Answer without = answer_of(nullptr, nominal, {}, 3.0);
      EXPECT_EQ(with.currents, without.currents);
      EXPECT_EQ(with.strength, without.strength);
      EXPECT_EQ(with.torques, without.torques);
      EXPECT_EQ(with.damping, without.damping);
      EXPECT_EQ(with.bodies, without.bodies);
      EXPECT_EQ(with.shown, without.shown);
      EXPECT_EQ(with.observed, without.observed);
      EXPECT_EQ(with.delay, without.delay);
    }
  }
}

// Each kind of effect has a number at which it is absent, or none at all.
TEST(StandardEffects, SaysOfEveryEffectWhereItIsAbsent) {
  for (const EffectKind* kind : standard_effects().kinds()) {
    int absent = 0;
    for (const EffectParameter& p : kind->parameters()) absent += p.absent.has_value() ? 1 : 0;
    EXPECT_EQ(absent, kind->parameters().empty() ? 0 : 1) << kind->id();
  }
}

TEST(StandardEffects, IsFiniteAtTheBoundsAndNextToAbsent) {
  for (const EffectKind* kind : standard_effects().kinds()) {
    for (std::size_t i = 0; i < kind->parameters().size(); ++i) {
      const EffectParameter& p = kind->parameters()[i];
      const double absent = p.absent.value_or(p.lower);
      for (const double value : {p.lower, p.upper, std::nextafter(absent, p.upper), std::nextafter(absent, p.lower)}) {
        if (!p.choices.empty() || !(value >= p.lower && value <= p.upper) || std::isinf(value)) continue;
        for (const double rate : {0.0, 1e-30, -25.0}) {
          for (const double state : {-1.0, 0.0, 1.0}) {
            ModelSpec spec = finger();
            Numbers values = kind->starts(finger_scale()).front();
            values[i] = value;
            const std::unique_ptr<const EffectTerm> term = kind->build(values, spec);
            const Numbers states(term == nullptr ? 0 : term->states(), state);
            EXPECT_TRUE(finite(answer_of(term.get(), spec, states, rate)))
                << kind->id() << ' ' << p.key << ' ' << value;
          }
        }
      }
    }
  }
}

// What a rig gives to everyone who watches it must not depend on whether slopes are asked for.
TEST(StandardEffects, AnswersAlikeWithAndWithoutSlopes) {
  for (const EffectKind* kind : standard_effects().kinds()) {
    ModelSpec spec = finger();
    const std::unique_ptr<const EffectTerm> term = kind->build(kind->starts(finger_scale()).front(), spec);
    if (term == nullptr) continue;
    const Numbers states(term->states(), 0.2);
    const JointVector angles = JointVector::Constant(2, 0.3);
    const JointVector rates = JointVector::Constant(2, -0.9);
    Numbers slopes(states.size());
    CoilCurrents plain = CoilCurrents::Constant(2, 0.7);
    CoilCurrents asked = plain;
    term->drive({.states = states.data()}, plain);
    term->drive({.states = states.data(), .slopes = slopes.data()}, asked);
    EXPECT_EQ(plain, asked) << kind->id();
    const EffectTerm::Kinematics motion{.chain = spec.chain, .angles = angles, .rates = rates};
    JointVector plain_torque = JointVector::Zero(2);
    JointVector asked_torque = JointVector::Zero(2);
    term->add_torques(motion, plain, {.states = states.data()}, plain_torque);
    term->add_torques(motion, plain, {.states = states.data(), .slopes = slopes.data()}, asked_torque);
    EXPECT_EQ(plain_torque, asked_torque) << kind->id();
  }
}

// At rest for long, by its own word and by its slopes.
TEST(StandardEffects, SettlesWhereItsSlopesVanish) {
  const CoilCurrents currents = CoilCurrents::Constant(2, 0.83);
  const JointVector angles = JointVector::Constant(2, 0.31);
  const JointVector rates = JointVector::Zero(2);
  for (const EffectKind* kind : standard_effects().kinds()) {
    for (const Numbers& start : kind->starts(finger_scale())) {
      ModelSpec spec = finger();
      const std::unique_ptr<const EffectTerm> term = kind->build(start, spec);
      if (term == nullptr || term->states() == 0) continue;
      const EffectTerm::Kinematics motion{.chain = spec.chain, .angles = angles, .rates = rates};
      Numbers states(term->states());
      Numbers slopes(term->states(), 1.0);
      term->settle(motion, currents, states.data());
      const EffectTerm::InternalStateView own{.states = states.data(), .slopes = slopes.data()};
      CoilCurrents through = currents;
      term->drive(own, through);
      CoilCurrents strength = through;
      term->magnetize(own, through, strength);
      JointVector torques = JointVector::Zero(2);
      term->add_torques(motion, strength, own, torques);
      JointVector shown = angles;
      JointVector shown_rates = rates;
      term->show(own, shown, shown_rates);
      // Of bodies the model writes the slopes: their rates, and what a force on them gives.
      std::vector<EffectTerm::Body> bodies(term->bodies(), {.coupling = JointVector::Zero(2)});
      term->describe_bodies(motion, strength, states.data(), bodies.data());
      for (std::size_t b = 0; b < bodies.size(); ++b) {
        slopes[b] = states[bodies.size() + b];
        EXPECT_NEAR(bodies[b].force, 0.0, 1e-14) << kind->id();
        slopes[bodies.size() + b] = 0.0;
      }
      for (const double slope : slopes) EXPECT_NEAR(slope, 0.0, 1e-14) << kind->id();  // rounding of states below 1
    }
  }
}

// A search passes from the plain kind to the one with further numbers: its first ones, then those.
TEST(StandardEffects, AddsFurtherNumbersAfterItsOwn) {
  std::set<std::string> ids;
  for (const EffectKind* kind : standard_effects().kinds()) {
    const EffectKind* further = kind->with_further_numbers();
    if (further == nullptr) continue;
    ids.emplace(further->id());
    EXPECT_EQ(further->id(), kind->id());
    EXPECT_EQ(further->stage(), kind->stage());
    EXPECT_EQ(further->with_further_numbers(), nullptr);
    const std::size_t own = kind->parameters().size();
    ASSERT_GT(further->parameters().size(), own);
    for (std::size_t i = 0; i < own; ++i) {
      EXPECT_EQ(further->parameters()[i].key, kind->parameters()[i].key);
      EXPECT_EQ(further->parameters()[i].absent, kind->parameters()[i].absent);
    }
    // A mount without the number is damped as mounts usually are, which is not absent.
    EXPECT_EQ(further->parameters()[own].absent.has_value(), kind->id() != "mount_compliance") << kind->id();
    for (const RigScale& scale : {finger_scale(), axis_scale()})
      for (const Numbers& start : further->starts(scale)) {
        EXPECT_EQ(error_text([&] { validate_effect({.kind = further, .values = start}); }), "");
        EXPECT_FALSE(is_absent(*further, start)) << kind->id();
      }
  }
  EXPECT_EQ(ids, (std::set<std::string>{"dry_friction", "mount_compliance", "mullins_softening"}));
}

TEST(StandardEffects, IsInAModelOnceWhateverItsNumbers) {
  const EffectKind* plain = standard_effects().find("dry_friction");
  ModelSpec spec = finger();
  spec.effects = {{.kind = plain, .values = {0.3e-3}},
                  {.kind = plain->with_further_numbers(), .values = {0.3e-3, 1.3, 0.5}}};
  EXPECT_EQ(error_text([&] { (void)Model(spec); }), "effect dry_friction: may be in a model once; given twice");
}

std::string effect_refusal(std::string_view id, Numbers values) {
  return error_text([&] { validate_effect({.kind = standard_effects().find(id), .values = std::move(values)}); });
}

TEST(Effect, SaysWhichValueBreaksWhichRule) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(effect_refusal("dry_friction", {0.6e-3}), "");
  EXPECT_EQ(effect_refusal("no_such_effect", {}), "effect: must be one of the catalogue; got none");
  EXPECT_EQ(effect_refusal("dry_friction", {}), "effect dry_friction: must have 1 value; got 0");
  EXPECT_EQ(effect_refusal("hysteresis", {1e-3}), "effect hysteresis: must have 2 values; got 1");
  EXPECT_EQ(effect_refusal("dry_friction", {-0.6e-3}), "effect dry_friction: torque_Nmm must be >= 0; got -0.6");
  EXPECT_EQ(effect_refusal("dry_friction", {nan}), "effect dry_friction: torque_Nmm must be >= 0; got nan");
  EXPECT_EQ(effect_refusal("dry_friction", {no_bound}), "effect dry_friction: torque_Nmm must be >= 0; got inf");
  EXPECT_EQ(effect_refusal("static_attraction", {nan, 1.0, 1.0}),
            "effect static_attraction: torque_Nmm must be finite; got nan");
  EXPECT_EQ(effect_refusal("rest_angle", {1.0}), "effect rest_angle: angle_deg must be from -45 to 45; got 57.2958");
  EXPECT_EQ(effect_refusal("end_stop", {0.3, 0.1, 0.5}), "effect end_stop: side must be -1 or 1; got 0.5");
}

std::string inapplicable(std::string_view id, const ModelSpec& spec) {
  return standard_effects().find(id)->inapplicable(spec).value_or("");
}

TEST(Effect, SaysWhyItCannotBeInAModel) {
  for (const EffectKind* kind : standard_effects().kinds()) {
    const bool of_motors = kind->id() == "load_friction" || kind->id() == "rotor_inertia";
    EXPECT_EQ(kind->inapplicable(finger()).value_or(""),
              of_motors ? "coil and magnet act across the joint, without a motor's shaft" : "")
        << kind->id();
  }
  const ModelSpec bare = rotor(1e-3);
  for (const char* id : {"driver_deadband", "driver_saturation", "current_offset", "coil_heating", "coil_lag",
                         "force_gain", "magnet_heating", "back_emf", "backlash", "off_axis_force", "coil_coil_force"})
    EXPECT_EQ(inapplicable(id, bare), "the model has no coils") << id;
  for (const char* id : {"rest_angle", "stiffness_hardening", "mullins_softening", "viscoelastic_creep"})
    EXPECT_EQ(inapplicable(id, bare), "no joint has a spring") << id;
  EXPECT_EQ(inapplicable("joint_asymmetry", bare), "the model has one joint only");
  EXPECT_EQ(inapplicable("base_tilt", bare), "the model has no gravity");
  for (const char* id : {"static_attraction", "dry_friction", "quadratic_drag", "hysteresis", "end_stop", "added_mass",
                         "mount_compliance", "measurement_delay", "tracking_lag", "angle_scale", "angle_offset"})
    EXPECT_EQ(inapplicable(id, bare), "") << id;
  ModelSpec loose = finger();
  loose.hinges[1].stiffness = 0.0;
  EXPECT_EQ(inapplicable("joint_asymmetry", loose), "no second joint has a spring");
}

TEST(Effect, SaysWhyNothingIsLeftToMakeExact) {
  ModelSpec lumped = finger();
  std::vector<HingePair> pairs = lumped.magnetics.hinge_pairs();
  for (HingePair& pair : pairs) pair.parts.reset();
  lumped.magnetics = MagneticStage(pairs, {});
  lumped.coil_row.reset();
  EXPECT_EQ(inapplicable("off_axis_force", lumped), "the geometry of the pairs is not known");
  EXPECT_EQ(inapplicable("coil_coil_force", lumped), "where the coils are is not known");
  Design design = paper_finger();
  design.choices.torque = magnetics::Fidelity::exact;
  EXPECT_EQ(inapplicable("off_axis_force", assemble_or_throw(design).model.nominal_spec()),
            "the forces are exact already");
  EXPECT_EQ(inapplicable("coil_coil_force", with_effect("coil_coil_force", {}, finger()).spec),
            "the forces between coils are in the model already");
  EXPECT_EQ(inapplicable("coil_coil_force", finger(Configuration::A)), "the model has one coil only");
  // One whose neighbours are exact may have far pairs that are not.
  ModelSpec mixed = finger(Configuration::C);
  mixed.magnetics = MagneticStage(pairs, mixed.magnetics.distant_pairs());
  EXPECT_EQ(inapplicable("off_axis_force", mixed), "");
}

}  // namespace
}  // namespace coilwright::actuator
