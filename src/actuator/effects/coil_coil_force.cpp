#include <algorithm>
#include <vector>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/actuator/parts/coil_row.hpp"

namespace coilwright::actuator::effects {
namespace {

class CoilCoilForce final : public DescribedEffect {
 public:
  CoilCoilForce()
      : DescribedEffect({.id = "coil_coil_force",
                         .stage = Stage::magnetics,
                         .description = "the coils pull at each other",
                         .equation = "q += i_a i_b (force of two coils at unit currents); no parameter",
                         .source = "sums of loops, or uniform windings: docs/theory/magnetics.md",
                         .check = "run one step through the first coil, one through the second and one through both: "
                                  "the third exceeds the sum"}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override {
    if (std::optional<std::string> reason = DescribedEffect::inapplicable(spec)) return reason;
    if (spec.coils < 2) return "the model has one coil only";
    if (spec.coil_row == nullptr) return "where the coils are is not known";
    const bool there = std::ranges::any_of(spec.magnetics.distant_pairs(),
                                           [](const DistantPair& pair) { return pair.second_coil >= 0; });
    if (there) return "the forces between coils are in the model already";
    return std::nullopt;
  }

  std::vector<std::vector<double>> starts(const RigScale& /*scale*/) const override { return {{}}; }

  std::unique_ptr<const EffectTerm> build(std::span<const double> /*values*/, ModelSpec& spec) const override {
    std::vector<DistantPair> far = spec.magnetics.distant_pairs();
    const std::vector<DistantPair> coils = spec.coil_row->pairs();
    far.insert(far.end(), coils.begin(), coils.end());
    spec.magnetics = MagneticStage(spec.magnetics.hinge_pairs(), std::move(far));
    return nullptr;
  }
};

}  // namespace

const EffectKind& coil_coil_force() {
  static const CoilCoilForce kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
