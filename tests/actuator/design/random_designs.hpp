#pragma once

#include <array>

#include "coilwright/actuator/design/design.hpp"
#include "random_draw.hpp"

// Random actuators over the whole range of sizes that a search may ask for, from a fixed seed.
namespace coilwright::actuator::random_designs {

using random_draw::Generator;
using random_draw::log_uniform;
using random_draw::uniform;
using random_draw::whole;

inline Design design(Generator& random, magnetics::Fidelity fidelity) {
  constexpr std::array<Configuration, 4> layouts{Configuration::A, Configuration::B, Configuration::C,
                                                 Configuration::D};
  Design out;
  out.layout = layout_of(layouts[random() % 4]);
  for (Component& part : out.layout) part.polarity = random() % 2 == 0 ? 1 : -1;
  out.coil = {.inner_radius = log_uniform(random, 1e-3, 10e-3),
              .turns_radial = whole(random, 2, 30),
              .turns_axial = whole(random, 5, 80),
              .wire_gauge = whole(random, 20, 40)};
  out.magnet.radius = log_uniform(random, 2e-3, 20e-3);
  out.magnet.length = log_uniform(random, 0.5e-3, 20e-3);
  out.body.gap = log_uniform(random, 0.2e-3, 4e-3);
  out.body.bottom_layer = log_uniform(random, 0.5e-3, 6e-3);
  out.choices.torque = fidelity;
  constexpr std::array windings{magnetics::CurrentDistribution::uniform, magnetics::CurrentDistribution::paper_shells,
                                magnetics::CurrentDistribution::layer_centres};
  out.choices.winding = windings[random() % 3];
  out.choices.faces = random() % 2 == 0 ? ContactChoice::hard_parts : ContactChoice::walls;
  return out;
}

}  // namespace coilwright::actuator::random_designs
