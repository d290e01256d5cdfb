#include <limits>
#include <vector>

#include "actuator/effects/joint_drive.hpp"
#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

class RotorInertia final : public DescribedEffect {
 public:
  RotorInertia()
      : DescribedEffect(
            {.id = "rotor_inertia",
             .stage = Stage::chain,
             .description = "the rotors of inner joints' motors turn with their joints, through a gear",
             .equation = "M_jj -> M_jj + J, every joint but the first, J = ratio^2 rotor inertia",
             .source = "kinetic energy of a rotor that a gear turns with a joint: Spong, J. Dyn. Syst. Meas. Control "
                       "109 (1987) 310, without the elasticity",
             .check = "turn an inner joint quickly by hand with its link unscrewed: what it resists with is the rotor",
             .parameters = {{.key = "inertia_kgm2",
                             .text = "of the rotor as the joint feels it, every joint but the first, where it is the "
                                     "link's own",
                             .lower = 0.0,
                             .upper = std::numeric_limits<double>::infinity(),
                             .absent = 0.0}}}) {}

  std::optional<std::string> inapplicable(const ModelSpec& spec) const override {
    if (auto reason = without_shafts(spec)) return reason;
    if (spec.chain.joints() < 2) return "a rotor at the first joint is the inertia of its link";
    return std::nullopt;
  }

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double whole = scale.torque * scale.angle / (scale.rate * scale.rate);
    return one_by_one({0.03 * whole, 0.3 * whole});
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    std::vector<mechanics::Link> links(spec.chain.links().begin(), spec.chain.links().end());
    for (std::size_t j = 1; j < links.size(); ++j) links[j].rotor_inertia += values[0];
    spec.chain = spec.chain.with_links(links);
    return nullptr;
  }
};

}  // namespace

const EffectKind& rotor_inertia() {
  static const RotorInertia kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
