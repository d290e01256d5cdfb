#include "coilwright/actuator/assemble.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "actuator/chain_of.hpp"
#include "actuator/pair_curves.hpp"
#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/hinges.hpp"
#include "coilwright/mechanics/silicone_hinge.hpp"

namespace coilwright::actuator {
namespace {

double half_pitch(const Dimensions& size, ComponentKind kind) {
  return kind == ComponentKind::magnet ? size.magnet_half_pitch : size.coil_half_pitch;
}

// Centre of component i: on the base (link -1) behind the first joint, or on link i - 1.
mechanics::LinkPoint centre(const Design& design, const Dimensions& size, int i) {
  const double half = half_pitch(size, design.layout[i].kind);
  return {.link = i - 1, .along = i == 0 ? -half : half, .offset = size.axis_offset};
}

// Index of component i among those of its kind.
int index_of(const Layout& layout, int i) {
  const ComponentKind kind = layout[static_cast<std::size_t>(i)].kind;
  return static_cast<int>(
      std::count_if(layout.begin(), layout.begin() + i, [kind](const Component& c) { return c.kind == kind; }));
}

std::vector<Hinge> hinges_of(const Design& design, const Dimensions& size, const mechanics::PlanarChain& chain) {
  const double modulus = design.body.modulus();
  const double stiffness = hinge_stiffness(design, size);
  const double damping = hinge_damping(design, size, first_mode_frequency(chain, stiffness));
  const int n = chain.joints();
  const mechanics::JointVector mobility = chain.joint_mobility();
  const bool walls = design.choices.faces == ContactChoice::walls;
  std::vector<Hinge> hinges(n);
  for (int j = 0; j < n; ++j) {
    const double wall = mechanics::wall_stiffness({.width = size.width,
                                                   .height = face_height_of_joint(design, size, j),
                                                   .thickness = gap_of_joint(design, j),
                                                   .young_modulus = modulus});
    hinges[j] = {.stiffness = stiffness,
                 .damping = damping,
                 .contact = {.closing_angle = walls ? 0.0 : -closing_angle_of_joint(design, size, j),
                             .stiffness = wall,
                             .damping = mechanics::contact_damping(wall, mobility[j])}};
  }
  return hinges;
}

DistantPair::Orientation orientation_of(const Design& design) {
  return design.choices.torque == magnetics::Fidelity::exact ? DistantPair::Orientation::dipoles
                                                             : DistantPair::Orientation::ignored;
}

// Null for a single coil.
std::shared_ptr<const CoilRow> coil_row_of(const Design& design, const Dimensions& size, const PairCurves& curves,
                                           const mechanics::PlanarChain& chain) {
  std::vector<PlacedCoil> coils;
  for (int i = 0; i < static_cast<int>(design.layout.size()); ++i) {
    const Component& part = design.layout[i];
    if (part.kind != ComponentKind::coil) continue;
    coils.push_back({.coil = curves.coil(), .centre = centre(design, size, i), .polarity = part.polarity * 1.0});
  }
  if (coils.size() < 2) return nullptr;
  return std::make_shared<const CoilRow>(chain, std::move(coils), orientation_of(design), design.curve_tolerance);
}

MagneticStage magnetics_of(const Design& design, const Dimensions& size, PairCurves& curves) {
  std::vector<HingePair> hinge_pairs;
  std::vector<DistantPair> distant_pairs;
  const int count = static_cast<int>(design.layout.size());
  for (int i = 0; i < count; ++i) {
    for (int k = i + 1; k < count; ++k) {
      const Component& near = design.layout[i];
      const Component& far = design.layout[k];
      const bool near_coil = near.kind == ComponentKind::coil;
      const bool far_coil = far.kind == ComponentKind::coil;
      if (near_coil && far_coil) continue;
      const double sense = near.polarity * far.polarity;
      if (k == i + 1) {
        hinge_pairs.push_back({.joint = i,
                               .coil = index_of(design.layout, near_coil ? i : k),
                               .sense = sense,
                               .torque_per_ampere = curves.hinge_torque(),
                               .parts = curves.hinge_parts(),
                               .magnet = index_of(design.layout, near_coil ? k : i)});
        continue;
      }
      const bool magnets = !near_coil && !far_coil;
      const AxialCurves& axial = magnets ? curves.magnet_magnet() : curves.coil_magnet();
      distant_pairs.push_back({.first = centre(design, size, i),
                               .second = centre(design, size, k),
                               .coil = magnets ? -1 : index_of(design.layout, near_coil ? i : k),
                               // Positive current sets a coil's moment against a magnet's.
                               .sense = magnets ? sense : -sense,
                               .magnet = index_of(design.layout, near_coil ? k : i),
                               .second_magnet = magnets ? index_of(design.layout, k) : -1,
                               .orientation = orientation_of(design),
                               .axial_force = axial.force,
                               .axial_energy = axial.energy});
    }
  }
  return {std::move(hinge_pairs), std::move(distant_pairs)};
}

// Nothing where all carry the whole current.
CoilCurrents shares_of(const Design& design) {
  if (has_one_current(design)) return {};
  const std::vector<double> shares = current_shares(design);
  return Eigen::Map<const Eigen::VectorXd>(shares.data(), static_cast<Eigen::Index>(shares.size()));
}

CoilElectrics electrics_of(const Design& design, const winding::Winding& coil) {
  return {.resistance = design.calibration.coil_resistance * coil.resistance(20.0),
          .inductance = coil.inductance(),
          .current_limit = current_limit(design),
          .table_limit = coil.wire().chassis_ampacity,
          .wire_length = coil.wire_length(),
          .copper_mass = coil.copper_mass()};
}

Assembly assemble_fitting(const Design& design) {
  const winding::Winding coil = winding_of(design);
  const Dimensions size = dimensions(design);
  std::vector<Segment> parts = segments(design, size);
  const mechanics::PlanarChain chain = chain_of(design, parts);
  PairCurves curves(design, size);
  MagneticStage magnetics = magnetics_of(design, size, curves);
  const CoilElectrics electrics = electrics_of(design, coil);
  Model model(as_built({.chain = chain,
                        .hinges = hinges_of(design, size, chain),
                        .magnetics = std::move(magnetics),
                        .coils = coil_count(design.layout),
                        .tip = {.link = chain.joints() - 1, .along = size.tip_length, .offset = 0.0},
                        .effects = {},
                        .coil_row = coil_row_of(design, size, curves, chain),
                        .coil_resistance = electrics.resistance,
                        .current_shares = shares_of(design)},
                       design.as_built));
  const double sense = model.magnetics().hinge_pairs().front().sense;
  return {.model = std::move(model),
          .dimensions = size,
          .segments = std::move(parts),
          .coil = electrics,
          .coils = coil_count(design.layout),
          .magnets = magnet_count(design.layout),
          .rest_force_per_ampere = sense * curves.rest_force_per_ampere()};
}

// An effect that the user asks for and that cannot be in this design: no fault of its shape.
struct UnfitEffect : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Assembly with_effects(Assembly assembly, const std::vector<Effect>& effects) {
  if (effects.empty()) return assembly;
  ModelSpec spec = assembly.model.nominal_spec();
  spec.effects = effects;
  try {
    assembly.model = Model(std::move(spec));
  } catch (const std::invalid_argument& error) {
    throw UnfitEffect(error.what());
  }
  return assembly;
}

}  // namespace

mechanics::PlanarChain chain_of(const Design& design, const std::vector<Segment>& segments) {
  std::vector<mechanics::Link> links;
  links.reserve(segments.size() - 1);
  for (std::size_t i = 1; i < segments.size(); ++i)
    links.push_back({.length = segments[i].length,
                     .com_along = segments[i].com_along,
                     .com_offset = segments[i].com_offset,
                     .mass = segments[i].mass,
                     .inertia = segments[i].inertia});
  return mechanics::PlanarChain(links, design.surroundings.gravity, design.surroundings.base_tilt);
}

double Assembly::mass() const {
  double sum = 0.0;
  for (const Segment& segment : segments) sum += segment.mass;
  return sum;
}

std::variant<Assembly, ConstructionFaults> assemble(const Design& design) {
  if (ConstructionFaults broken = construction_faults(design); !broken.empty()) return broken;
  try {
    return with_effects(assemble_fitting(design), design.effects);
  } catch (const UnfitEffect& error) {
    return ConstructionFaults{{.rule = error.what(), .excess = 1.0}};
  } catch (const std::logic_error& error) {
    // No rule of ours, but a formula outside its range: a coil that is 1e4 times wider than long, say.
    return ConstructionFaults{{.rule = std::string("shape too extreme to compute: ") + error.what(), .excess = 1.0}};
  }
}

Assembly assemble_or_throw(const Design& design) {
  std::variant<Assembly, ConstructionFaults> result = assemble(design);
  if (const ConstructionFaults* broken = std::get_if<ConstructionFaults>(&result))
    throw std::invalid_argument(broken->front().rule);
  return std::get<Assembly>(std::move(result));
}

}  // namespace coilwright::actuator
