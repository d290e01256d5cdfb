#include "measurement/replay/rig_change.hpp"

#include <utility>
#include <vector>

namespace coilwright::measurement::replay {
namespace {

using actuator::Effect;
using actuator::ModelSpec;
using mechanics::Link;

// Builds in the effects that only change the chain, so that a weight comes on top of them: a payload at the segment's
// own centre of mass stays there.
void build_in_chain_effects(ModelSpec& spec) {
  std::vector<Effect> left;
  for (Effect& effect : std::exchange(spec.effects, {})) {
    ModelSpec changed = spec;
    const bool whole =
        effect.kind->stage() == actuator::Stage::chain && effect.kind->build(effect.values, changed) == nullptr;
    if (whole)
      spec = std::move(changed);
    else
      left.push_back(std::move(effect));
  }
  spec.effects = std::move(left);
}

Link with_point_mass(const Link& link, double mass) {
  const double whole = link.mass + mass;
  const double along = (link.mass * link.com_along + mass * link.length) / whole;
  const double offset = link.mass * link.com_offset / whole;
  const double from_link = along - link.com_along;
  const double across_link = offset - link.com_offset;
  const double from_mass = along - link.length;
  return {.length = link.length,
          .com_along = along,
          .com_offset = offset,
          .mass = whole,
          .inertia = link.inertia + link.mass * (from_link * from_link + across_link * across_link) +
                     mass * (from_mass * from_mass + offset * offset)};
}

}  // namespace

ModelSpec on_changed_rig(ModelSpec spec, const data::RigChange& change) {
  if (change == data::RigChange{}) return spec;
  if (!current_flows(change) && change.coil == data::CoilWiring::open)
    std::erase_if(spec.effects, [](const Effect& effect) { return effect.kind->needs_closed_circuit(); });
  if (change.tip_mass > 0.0) {
    build_in_chain_effects(spec);
    std::vector<Link> links(spec.chain.links().begin(), spec.chain.links().end());
    links.back() = with_point_mass(links.back(), change.tip_mass);
    spec.chain = spec.chain.with_links(links);
  }
  spec.chain = spec.chain.under_gravity(spec.chain.gravity(), spec.chain.base_tilt() + change.base_turn);
  return spec;
}

bool current_flows(const data::RigChange& change) {
  return change.coil == data::CoilWiring::driven;
}

}  // namespace coilwright::measurement::replay
