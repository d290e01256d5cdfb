#include "coilwright/simulation/shut_joints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "coilwright/simulation/pressed_joints.hpp"
#include "simulation/shut_pose.hpp"

namespace coilwright::simulation {
namespace {

using actuator::CoilCurrents;
using actuator::ComponentKind;
using actuator::DistantPair;
using actuator::HingePair;
using actuator::Layout;
using actuator::MagneticStage;
using mechanics::JointVector;

// A pair of the row's magnetics by itself, with the force along the chain by which its bodies attract each other, N.
struct Pull {
  Bodies bodies{};
  bool magnets{};
  double force{};
  JointVector torques{};
};

std::vector<Pull> pulls_of(const DesignView& design, const JointVector& angles, const CoilCurrents& currents) {
  const actuator::Model& model = design.assembly.model;
  const MagneticStage& magnetics = model.magnetics();
  const auto torques = [&](const MagneticStage& one) {
    JointVector out = JointVector::Zero(model.joints());
    one.add_torques(model.chain(), angles, currents, out);
    return out;
  };
  std::vector<Pull> out;
  for (const HingePair& pair : magnetics.hinge_pairs()) {
    // Of all hinges, as the first has it.
    const double per_ampere = design.assembly.rest_force_per_ampere / magnetics.hinge_pairs().front().sense;
    const auto near = static_cast<std::size_t>(pair.joint);
    out.push_back({.bodies = {.first = near, .second = near + 1},
                   .force = -pair.sense * currents[pair.coil] * per_ampere,
                   .torques = torques({{pair}, {}})});
  }
  const mechanics::LinkFrames frames = model.chain().frames(angles);
  const auto place = [&](const mechanics::LinkPoint& point) {
    return frames[static_cast<std::size_t>(point.link + 1)].at(point.along, point.offset);
  };
  for (const DistantPair& pair : magnetics.distant_pairs()) {
    if (pair.second_coil >= 0) continue;
    const double strength = pair.sense * (pair.coil < 0 ? 1.0 : currents[pair.coil]);
    out.push_back({.bodies = bodies_of(pair),
                   .magnets = pair.coil < 0,
                   .force = -strength * pair.axial_force->value((place(pair.second) - place(pair.first)).norm()),
                   .torques = torques({{}, {pair}})});
  }
  return out;
}

// What closes a joint most.
struct Closer {
  enum class Kind { magnets, coil, weight };
  Kind kind{};
  const Pull* pull = nullptr;
};

std::optional<Closer> closer_of(int joint, const std::vector<Pull>& pulls, double weight) {
  double of_magnets = 0.0;
  double of_coils = 0.0;
  for (const Pull& each : pulls) (each.magnets ? of_magnets : of_coils) += each.torques[joint];
  const double least = std::min({of_magnets, of_coils, weight});
  if (least >= 0.0) return std::nullopt;
  if (least == weight) return Closer{.kind = Closer::Kind::weight};
  const bool magnets = least == of_magnets;
  const Pull* most = nullptr;
  for (const Pull& each : pulls)
    if (each.magnets == magnets && (most == nullptr || each.torques[joint] < most->torques[joint])) most = &each;
  return Closer{.kind = magnets ? Closer::Kind::magnets : Closer::Kind::coil, .pull = most};
}

std::string text_of(const Closer& closer, const Layout& layout, double coil_force, double current) {
  if (closer.kind == Closer::Kind::weight) return "weight closes them";
  const auto [first, second] = closer.pull->bodies;
  const std::string one = part_name(layout, first);
  const std::string other = part_name(layout, second);
  if (closer.kind == Closer::Kind::coil)
    return fmt::format("{} and {} attract each other with {:.3g} N at {:.3g} A", one, other, closer.pull->force,
                       current);
  std::vector<std::string> between;
  for (std::size_t part = first + 1; part < second; ++part) between.push_back(part_name(layout, part));
  return fmt::format(
      "{} and {} attract each other through {} with {:.3g} N, and a coil gives its magnet {:.3g} N at {:.3g} A", one,
      other, listed(between), closer.pull->force, coil_force, current);
}

// The closer of each shut joint; the pulls that they point to live as long as the result.
struct Closers {
  std::vector<Pull> pulls{};
  std::vector<std::pair<int, Closer>> of_joints{};
};

Closers closers_of(const DesignView& design, const ShutPose& pose) {
  const actuator::Model& model = design.assembly.model;
  Closers out{.pulls = pulls_of(design, pose.angles, model.all_coils(pose.current))};
  const JointVector weight = -model.chain().gravity_torques(pose.angles);
  for (const int joint : pose.joints())
    if (const auto closer = closer_of(joint, out.pulls, weight[joint])) out.of_joints.emplace_back(joint, *closer);
  return out;
}

}  // namespace

std::optional<ShutPose> shut_pose(const DesignView& design) {
  const std::optional<FreeMotion>& motion = design.performance.free.motion;
  if (!motion) return std::nullopt;
  const actuator::Model& model = design.assembly.model;
  const JointVector& rest = design.performance.cold.rest_angles;
  std::vector<int> at_rest = pressed_joints(model, rest);
  std::vector<int> under_current = pressed_joints(model, motion->steady_angles);
  if (at_rest.empty() && under_current.empty()) return std::nullopt;
  const bool is_at_rest = under_current.empty();
  return ShutPose{.at_rest = std::move(at_rest),
                  .under_current = std::move(under_current),
                  .angles = is_at_rest ? rest : motion->steady_angles,
                  .current = is_at_rest ? 0.0 : design.point.current};
}

std::string part_name(const Layout& layout, std::size_t part) {
  const ComponentKind kind = layout[part].kind;
  const auto number = std::count_if(layout.begin(), layout.begin() + static_cast<std::ptrdiff_t>(part) + 1,
                                    [kind](const actuator::Component& each) { return each.kind == kind; });
  return fmt::format("{} {}", kind == ComponentKind::coil ? "coil" : "magnet", number);
}

std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

Bodies bodies_of(const DistantPair& pair) {
  return {.first = static_cast<std::size_t>(pair.first.link + 1),
          .second = static_cast<std::size_t>(pair.second.link + 1)};
}

std::optional<Bodies> magnets_that_shut(const DesignView& design, const ShutPose& pose) {
  const Closers closers = closers_of(design, pose);
  const auto found =
      std::ranges::find(closers.of_joints, Closer::Kind::magnets, [](const auto& each) { return each.second.kind; });
  if (found == closers.of_joints.end()) return std::nullopt;
  return found->second.pull->bodies;
}

std::string what_shuts_joints(const DesignView& design) {
  const auto pose = shut_pose(design);
  if (!pose) return {};
  const Closers closers = closers_of(design, *pose);
  double coil_force = 0.0;
  for (const Pull& each : closers.pulls)
    if (!each.magnets && each.bodies.second == each.bodies.first + 1)
      coil_force = std::max(coil_force, std::abs(each.force));
  std::vector<std::string> texts;
  for (const auto& [joint, closer] : closers.of_joints)
    if (std::string text = text_of(closer, design.design.layout, coil_force, pose->current);
        std::ranges::find(texts, text) == texts.end())
      texts.push_back(std::move(text));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace coilwright::simulation
