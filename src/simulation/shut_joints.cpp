#include "coilwright/simulation/shut_joints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>
#include <optional>
#include <tuple>
#include <utility>

#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/pressed_joints.hpp"

namespace coilwright::simulation {
namespace {

using actuator::CoilCurrents;
using actuator::ComponentKind;
using actuator::DistantPair;
using actuator::HingePair;
using actuator::Layout;
using actuator::MagneticStage;
using mechanics::JointVector;

// "coil 2": a part of a row by its number among those of its kind, from the base.
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

// The bodies of a pair by their places in the row: a segment a joint, and the first part in the base.
struct Bodies {
  std::size_t first{};
  std::size_t second{};
  friend bool operator==(const Bodies&, const Bodies&) = default;
};

Bodies bodies_of(const DistantPair& pair) {
  return {.first = static_cast<std::size_t>(pair.first.link + 1),
          .second = static_cast<std::size_t>(pair.second.link + 1)};
}

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

// The joints of a free finger that are shut: under current, or at rest where none is.
struct ShutPose {
  std::vector<int> joints{};
  const JointVector& angles;
  double current{};
};

std::optional<ShutPose> shut_pose(const DesignView& design) {
  const Performance& performance = design.performance;
  if (!performance.free.motion) return std::nullopt;
  const actuator::Model& model = design.assembly.model;
  const JointVector& steady = performance.free.motion->steady_angles;
  const JointVector& rest = performance.cold.rest_angles;
  if (std::vector<int> joints = pressed_joints(model, steady); !joints.empty())
    return ShutPose{.joints = std::move(joints), .angles = steady, .current = design.point.current};
  if (std::vector<int> joints = pressed_joints(model, rest); !joints.empty())
    return ShutPose{.joints = std::move(joints), .angles = rest};
  return std::nullopt;
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
  for (const int joint : pose.joints)
    if (const auto closer = closer_of(joint, out.pulls, weight[joint])) out.of_joints.emplace_back(joint, *closer);
  return out;
}

// A model of the same parts, of which some are turned round: what a pair does changes its sign with either of its own.
actuator::Model turned(const actuator::Model& model, unsigned mask) {
  const auto sign = [mask](const Bodies& bodies) {
    return ((mask >> bodies.first) ^ (mask >> bodies.second)) & 1U ? -1.0 : 1.0;
  };
  actuator::ModelSpec spec = model.nominal_spec();
  std::vector<HingePair> hinge = spec.magnetics.hinge_pairs();
  std::vector<DistantPair> distant = spec.magnetics.distant_pairs();
  for (HingePair& pair : hinge) {
    const auto near = static_cast<std::size_t>(pair.joint);
    pair.sense *= sign({.first = near, .second = near + 1});
  }
  for (DistantPair& pair : distant) pair.sense *= sign(bodies_of(pair));
  spec.magnetics = MagneticStage(std::move(hinge), std::move(distant));
  return actuator::Model(std::move(spec));
}

// How a model stands at rest and under a current; nothing where it folds.
struct Poses {
  std::size_t shut_at_rest{};
  std::size_t shut{};
  double stroke{};  // rad
};

std::optional<Poses> poses_of(const actuator::Model& model, double current) {
  const auto rest = find_equilibrium(model, model.all_coils(0.0), JointVector::Zero(model.joints()));
  if (!rest) return std::nullopt;
  const auto steady = find_equilibrium(model, model.all_coils(current), *rest);
  if (!steady) return std::nullopt;
  return Poses{.shut_at_rest = pressed_joints(model, *rest).size(),
               .shut = pressed_joints(model, *steady).size(),
               .stroke = steady->sum() - rest->sum()};
}

// The design as it would be built, where that opens every joint.
std::optional<EvaluatedDesign> opened(const DesignView& taken, actuator::Design design, double current) {
  OperatingPoint point = taken.point;
  point.current = current;
  try {
    EvaluatedDesign out = evaluate(std::move(design), point);
    const std::optional<FreeMotion>& motion = out.performance.free.motion;
    const JointVector& steady = motion ? motion->steady_angles : out.performance.cold.steady_angles;
    if (!pressed_joints(out.assembly.model, steady).empty()) return std::nullopt;
    return out;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;  // it cannot be built or does not come to rest, and is no advice
  }
}

void add_polarities(const DesignView& taken, std::vector<OpeningChange>& out) {
  struct Candidate {
    unsigned mask{};
    Poses poses;
  };
  const Layout& layout = taken.design.layout;
  const auto parts = static_cast<int>(layout.size());
  constexpr int all_up_to = 9;  // parts of a row of which every polarity is tried; of longer ones two turned parts
  const int most_turned = parts <= all_up_to ? parts / 2 : 2;
  std::vector<Candidate> found;
  for (unsigned mask = 1; mask < 1U << static_cast<unsigned>(parts); ++mask) {
    if (std::popcount(mask) > most_turned) continue;
    const auto poses = poses_of(turned(taken.assembly.model, mask), taken.point.current);
    if (poses && poses->shut == 0 && poses->stroke > 0.0) found.push_back({.mask = mask, .poses = *poses});
  }
  const auto add_first = [&](auto order) {
    std::ranges::stable_sort(found, {}, order);
    constexpr std::size_t tries = 2;  // a step that rings takes a second each
    for (const Candidate& each : std::span(found).first(std::min(tries, found.size()))) {
      actuator::Design design = taken.design;
      std::vector<std::string> names;
      for (std::size_t part = 0; part < layout.size(); ++part)
        if ((each.mask >> part & 1U) != 0) {
          design.layout[part].polarity *= -1;
          names.push_back(part_name(layout, part));
        }
      const std::string turned_parts = listed(names);
      if (std::ranges::find(out, turned_parts, &OpeningChange::parts) != out.end()) return;
      if (auto result = opened(taken, std::move(design), taken.point.current))
        return out.push_back({.of = OpeningChange::Of::polarity, .parts = turned_parts, .result = std::move(*result)});
    }
  };
  add_first([](const Candidate& each) {
    return std::tuple(std::popcount(each.mask), each.poses.shut_at_rest, -each.poses.stroke);
  });
  add_first([](const Candidate& each) { return std::tuple(each.poses.shut_at_rest, -each.poses.stroke); });
}

void add_rows(const DesignView& taken, const Closers& closers, std::vector<OpeningChange>& out) {
  const auto magnets = std::ranges::find_if(closers.of_joints,
                                            [](const auto& each) { return each.second.kind == Closer::Kind::magnets; });
  if (magnets == closers.of_joints.end()) return;
  const auto [first, second] = magnets->second.pull->bodies;
  const auto add = [&](Layout layout) {
    actuator::Design design = taken.design;
    design.layout = std::move(layout);
    auto result = opened(taken, std::move(design), taken.point.current);
    if (result) out.push_back({.of = OpeningChange::Of::row, .parts = {}, .result = std::move(*result)});
    return result.has_value();
  };
  const auto at = [](const Layout& layout, std::size_t part) {
    return layout.begin() + static_cast<std::ptrdiff_t>(part);
  };
  // A coil beside no magnet drives nothing.
  add(Layout(taken.design.layout.begin(), at(taken.design.layout, first + 2)));
  constexpr std::size_t most_more = 3;
  for (std::size_t more = 1; more <= most_more; ++more) {
    Layout longer = taken.design.layout;
    longer.insert(at(longer, second), more, longer[second - 1]);
    if (add(std::move(longer))) return;
  }
}

void add_current(const DesignView& taken, std::vector<OpeningChange>& out) {
  const actuator::Model& model = taken.assembly.model;
  const auto opens = [&](double current) {
    const auto poses = poses_of(model, current);
    return poses && poses->shut == 0;
  };
  const double unit = std::max(std::abs(taken.point.current), 1e-2 * taken.assembly.coil.current_limit);
  constexpr double growth = 1.15;
  int tries = 2;  // of a step that may ring for a minute
  const double most = 30.0 * std::max(unit, taken.assembly.coil.current_limit);
  for (double current = unit; current < most; current *= growth)
    for (const double sign : {1.0, -1.0}) {
      if (!opens(sign * current)) continue;
      const double step = std::pow(10.0, std::floor(std::log10(current)) - 2.0);  // of three digits
      const double next = std::ceil(current / step) * step;
      if (auto result = opened(taken, taken.design, sign * next))
        return out.push_back({.of = OpeningChange::Of::current, .parts = {}, .result = std::move(*result)});
      if (--tries == 0) return;
    }
}

}  // namespace

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

std::vector<OpeningChange> what_opens_joints(const DesignView& design) {
  const auto pose = shut_pose(design);
  const bool under_current =
      pose && !pressed_joints(design.assembly.model, design.performance.free.motion->steady_angles).empty();
  if (!under_current) return {};
  std::vector<OpeningChange> out;
  add_polarities(design, out);
  add_rows(design, closers_of(design, *pose), out);
  add_current(design, out);
  return out;
}

}  // namespace coilwright::simulation
