#include <algorithm>

#include "actuator/effects/effect_rows.hpp"

// The chain's masses, and how it hangs. None leaves a term: they change the chain.
namespace coilwright::actuator::effects {
namespace {

// RigScale knows torques and motion, not lengths: centres of mass of a finger, an arm, and an axis written as a link of
// unit length lie this far from their joints, m.
constexpr double levers[] = {0.03, 0.2, 1.0};

// Of the declared mass of the last link, what stays whatever is taken away: a segment without mass has no motion. No
// tip segment was ever weighed that far off; a fit that ends there is a wrong model.
constexpr double least_share = 0.05;

std::vector<mechanics::Link> links_of(const ModelSpec& spec) {
  return {spec.chain.links().begin(), spec.chain.links().end()};
}

}  // namespace

EffectProperties added_mass() {
  return {.id = "added_mass",
          .stage = Stage::chain,
          .description = "the tip segment is heavier (or lighter) than the model says: a payload, a wrong mass",
          .equation = "m_tip -> m_tip + dm, at the segment's centre of mass; at least 1/20 of m_tip stays",
          .source = "point mass at a link's centre of mass; definition",
          .check = "weigh the last segment, with all that is fixed to it, on a scale",
          .parameters = {about_zero("mass_g", "besides the declared mass of the last link")},
          .starts =
              [](const RigScale& scale) {
                const double inertia = scale.torque * scale.angle / (scale.rate * scale.rate);
                Starts out;
                for (const double lever : levers) out.push_back({0.1 * inertia / (lever * lever)});
                return out;
              },
          .build = [](Values values, ModelSpec& spec) -> Term {
            std::vector<mechanics::Link> links = links_of(spec);
            links.back().mass += std::max(values[0], (least_share - 1.0) * links.back().mass);
            spec.chain = spec.chain.with_links(links);
            return nullptr;
          }};
}

EffectProperties rotor_inertia() {
  return {
      .id = "rotor_inertia",
      .stage = Stage::chain,
      .description = "the rotors of inner joints' motors turn with their joints, through a gear",
      .equation = "M_jj -> M_jj + J, every joint but the first, J = ratio^2 rotor inertia",
      .source =
          "kinetic energy of a rotor that a gear turns with a joint: Spong, J. Dyn. Syst. Meas. Control 109 (1987) "
          "310, without the elasticity",
      .check = "turn an inner joint quickly by hand with its link unscrewed: what it resists with is the rotor",
      .parameters = {from_zero(
          "inertia_kgm2", "of the rotor as the joint feels it, every joint but the first, where it is the link's own")},
      .starts = shares_of([](const RigScale& scale) { return scale.torque * scale.angle / (scale.rate * scale.rate); },
                          {0.03, 0.3}),
      .build = [](Values values, ModelSpec& spec) -> Term {
        std::vector<mechanics::Link> links = links_of(spec);
        for (std::size_t j = 1; j < links.size(); ++j) links[j].rotor_inertia += values[0];
        spec.chain = spec.chain.with_links(links);
        return nullptr;
      },
      .inapplicable = [](const ModelSpec& spec) -> std::optional<std::string> {
        if (auto reason = without_shafts(spec)) return reason;
        if (spec.chain.joints() < 2) return "a rotor at the first joint is the inertia of its link";
        return std::nullopt;
      }};
}

EffectProperties base_tilt() {
  return {.id = "base_tilt",
          .stage = Stage::chain,
          .description = "the mounting is not level",
          .equation = "V(theta_1, ...) -> V(theta_1 + phi, ...): gravity turned by phi",
          .source = "definition; mechanics::PlanarChain",
          .check = "put a spirit level on the mount, or hang a plumb line beside the finger",
          .parameters = {about_zero("angle_deg", "of the whole chain towards opening, besides the declared tilt",
                                    45.0 / degrees)},
          .starts = always({2.0 / degrees, -2.0 / degrees}),
          .build = [](Values values, ModelSpec& spec) -> Term {
            spec.chain = spec.chain.under_gravity(spec.chain.gravity(), spec.chain.base_tilt() + values[0]);
            return nullptr;
          },
          .inapplicable = [](const ModelSpec& spec) -> std::optional<std::string> {
            if (spec.chain.gravity() == 0.0) return "the model has no gravity";
            return std::nullopt;
          }};
}

}  // namespace coilwright::actuator::effects
