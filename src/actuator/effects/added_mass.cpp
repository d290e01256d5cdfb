#include <algorithm>
#include <limits>

#include "actuator/effects/starts.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {
namespace {

// RigScale knows torques and motion, not lengths: centres of mass of a finger, an arm, and an axis written as a link of
// unit length lie this far from their joints, m.
constexpr double levers[] = {0.03, 0.2, 1.0};

// Of the declared mass of the last link, what stays whatever is taken away: a segment without mass has no motion. No
// tip segment was ever weighed that far off; a fit that ends there is a wrong model.
constexpr double least_share = 0.05;

class AddedMass final : public DescribedEffect {
 public:
  AddedMass()
      : DescribedEffect(
            {.id = "added_mass",
             .stage = Stage::chain,
             .description = "the tip segment is heavier (or lighter) than the model says: a payload, a wrong mass",
             .equation = "m_tip -> m_tip + dm, at the segment's centre of mass; at least 1/20 of m_tip stays",
             .source = "point mass at a link's centre of mass; definition",
             .check = "weigh the last segment, with all that is fixed to it, on a scale",
             .parameters = {{.key = "mass_g",
                             .text = "besides the declared mass of the last link",
                             .lower = -std::numeric_limits<double>::infinity(),
                             .upper = std::numeric_limits<double>::infinity(),
                             .absent = 0.0}}}) {}

  std::vector<std::vector<double>> starts(const RigScale& scale) const override {
    const double inertia = scale.torque * scale.angle / (scale.rate * scale.rate);
    std::vector<std::vector<double>> out;
    for (const double lever : levers) out.push_back({0.1 * inertia / (lever * lever)});
    return out;
  }

  std::unique_ptr<const EffectTerm> build(std::span<const double> values, ModelSpec& spec) const override {
    std::vector<mechanics::Link> links(spec.chain.links().begin(), spec.chain.links().end());
    links.back().mass += std::max(values[0], (least_share - 1.0) * links.back().mass);
    spec.chain = spec.chain.with_links(links);
    return nullptr;
  }
};

}  // namespace

const EffectKind& added_mass() {
  static const AddedMass kind;
  return kind;
}

}  // namespace coilwright::actuator::effects
