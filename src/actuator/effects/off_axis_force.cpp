#include <algorithm>
#include <vector>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/actuator/parts/hinge_pair_parts.hpp"

namespace coilwright::actuator::effects {
namespace {

bool can_be_exact(const HingePair& pair) {
  return pair.parts != nullptr && pair.parts->spec().fidelity != magnetics::Fidelity::exact;
}

bool can_be_exact(const DistantPair& pair) {
  return pair.orientation == DistantPair::Orientation::ignored;
}

// What Fidelity::exact is to a design: the whole wrench between neighbours, dipoles beyond.
class OffAxisForce final : public DescribedEffect {
 public:
  OffAxisForce()
      : DescribedEffect(
            {.id = "off_axis_force",
             .stage = Stage::magnetics,
             .description = "coil and magnet tilt against each other, and the coaxial formula does not know it",
             .equation = "dq/di = the exact torque of the tilted, displaced pair; no parameter",
             .source = "I dl x B over the winding in the cylinder's exact field: docs/theory/magnetics.md",
             .check = "measure the torque over the angle at one current (a run of kind static_torque)"}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override {
    if (std::optional<std::string> reason = DescribedEffect::inapplicable(spec)) return reason;
    const std::vector<HingePair>& near = spec.magnetics.hinge_pairs();
    const std::vector<DistantPair>& far = spec.magnetics.distant_pairs();
    const auto inexact = [](const auto& pair) { return can_be_exact(pair); };
    if (std::ranges::any_of(near, inexact) || std::ranges::any_of(far, inexact)) return std::nullopt;
    const bool known = std::ranges::any_of(near, [](const HingePair& pair) { return pair.parts != nullptr; });
    return known ? "the forces are exact already" : "the geometry of the pairs is not known";
  }

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override { return {{}}; }

  std::unique_ptr<const EffectTerm> build(std::span<const double> /*values*/, ModelSpec& spec) const override {
    std::vector<HingePair> near = spec.magnetics.hinge_pairs();
    std::vector<DistantPair> far = spec.magnetics.distant_pairs();
    for (HingePair& pair : near)
      if (can_be_exact(pair)) pair.torque_per_ampere = pair.parts->exact_torque();
    for (DistantPair& pair : far) pair.orientation = DistantPair::Orientation::dipoles;
    spec.magnetics = MagneticStage(std::move(near), std::move(far));
    return nullptr;
  }
};

}  // namespace

const EffectKind& off_axis_force() {
  static const OffAxisForce kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
