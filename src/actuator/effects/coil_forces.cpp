#include <algorithm>

#include "actuator/effects/effect_rows.hpp"
#include "coilwright/actuator/parts/coil_row.hpp"
#include "coilwright/actuator/parts/hinge_pair_parts.hpp"

// The forces between coils and magnets are not as declared.
namespace coilwright::actuator::effects {
namespace {

bool can_be_exact(const HingePair& pair) {
  return pair.parts != nullptr && pair.parts->spec().fidelity != magnetics::Fidelity::exact;
}

bool can_be_exact(const DistantPair& pair) {
  return pair.orientation == DistantPair::Orientation::ignored;
}

std::optional<std::string> without_inexact_pairs(const ModelSpec& spec) {
  if (auto reason = without_coils(spec)) return reason;
  const std::vector<HingePair>& near = spec.magnetics.hinge_pairs();
  const auto inexact = [](const auto& pair) { return can_be_exact(pair); };
  if (std::ranges::any_of(near, inexact) || std::ranges::any_of(spec.magnetics.distant_pairs(), inexact))
    return std::nullopt;
  const bool known = std::ranges::any_of(near, [](const HingePair& pair) { return pair.parts != nullptr; });
  return known ? "the forces are exact already" : "the geometry of the pairs is not known";
}

std::optional<std::string> without_unknown_coil_pairs(const ModelSpec& spec) {
  if (auto reason = without_coils(spec)) return reason;
  if (spec.coils < 2) return "the model has one coil only";
  if (spec.coil_row == nullptr) return "where the coils are is not known";
  const auto is_of_coils = [](const DistantPair& pair) { return pair.second_coil >= 0; };
  if (std::ranges::any_of(spec.magnetics.distant_pairs(), is_of_coils))
    return "the forces between coils are in the model already";
  return std::nullopt;
}

class GainTerm final : public EffectTerm {
 public:
  explicit GainTerm(double gain) : gain_(gain) {}

  void magnetize(InternalStateView /*own*/, const CoilCurrents& /*currents*/, CoilCurrents& strength) const override {
    strength *= gain_;
  }

 private:
  double gain_;
};

}  // namespace

// What Fidelity::exact is to a design: the whole wrench between neighbours, dipoles beyond.
EffectProperties off_axis_force() {
  return {.id = "off_axis_force",
          .stage = Stage::magnetics,
          .description = "coil and magnet tilt against each other, and the coaxial formula does not know it",
          .equation = "dq/di = the exact torque of the tilted, displaced pair; no parameter",
          .source = "I dl x B over the winding in the cylinder's exact field: docs/theory/magnetics.md",
          .check = "measure the torque over the angle at one current (a run of kind static_torque)",
          .starts = [](const RigScale& /*scale*/) { return Starts{{}}; },
          .build = [](Values /*values*/, ModelSpec& spec) -> Term {
            std::vector<HingePair> near = spec.magnetics.hinge_pairs();
            std::vector<DistantPair> far = spec.magnetics.distant_pairs();
            for (HingePair& pair : near)
              if (can_be_exact(pair)) pair.torque_per_ampere = pair.parts->exact_torque();
            for (DistantPair& pair : far) pair.orientation = DistantPair::Orientation::dipoles;
            spec.magnetics = MagneticStage(std::move(near), std::move(far));
            return nullptr;
          },
          .inapplicable = without_inexact_pairs};
}

EffectProperties coil_coil_force() {
  return {
      .id = "coil_coil_force",
      .stage = Stage::magnetics,
      .description = "the coils pull at each other",
      .equation = "q += i_a i_b (force of two coils at unit currents); no parameter",
      .source = "sums of loops, or uniform windings: docs/theory/magnetics.md",
      .check =
          "run one step through the first coil, one through the second and one through both: the third exceeds the sum",
      .starts = [](const RigScale& /*scale*/) { return Starts{{}}; },
      .build = [](Values /*values*/, ModelSpec& spec) -> Term {
        std::vector<DistantPair> far = spec.magnetics.distant_pairs();
        const std::vector<DistantPair> coils = spec.coil_row->pairs();
        far.insert(far.end(), coils.begin(), coils.end());
        spec.magnetics = MagneticStage(spec.magnetics.hinge_pairs(), std::move(far));
        return nullptr;
      },
      .inapplicable = without_unknown_coil_pairs};
}

EffectProperties force_gain() {
  return {.id = "force_gain",
          .stage = Stage::magnetics,
          .description = "all forces of the coils are off by one factor: remanence, turns or current sensor",
          .equation = "f -> gamma f",
          .source =
              "the force is a product of remanence, turns and current: Ravaud et al., IEEE Trans. Magn. 46 (2010) 3585",
          .check =
              "measure one torque or force at rest under a known current (runs of kind static_torque or blocked_force)",
          .parameters = {about_one("gain", "real over declared force of a coil at a current", 10.0)},
          .starts = always({0.9, 1.1}),
          .build = [](Values values, ModelSpec& /*spec*/) -> Term { return std::make_unique<GainTerm>(values[0]); }};
}

}  // namespace coilwright::actuator::effects
