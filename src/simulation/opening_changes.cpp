#include <algorithm>
#include <bit>
#include <cmath>
#include <new>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/pressed_joints.hpp"
#include "coilwright/simulation/shut_joints.hpp"
#include "simulation/shut_pose.hpp"

namespace coilwright::simulation {
namespace {

using actuator::DistantPair;
using actuator::HingePair;
using actuator::Layout;
using actuator::MagneticStage;
using mechanics::JointVector;

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

void add_rows(const DesignView& taken, const Bodies& magnets, std::vector<OpeningChange>& out) {
  const auto [first, second] = magnets;
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

std::vector<OpeningChange> what_opens_joints(const DesignView& design) {
  const auto pose = shut_pose(design);
  if (!pose || pose->under_current.empty()) return {};
  std::vector<OpeningChange> out;
  add_polarities(design, out);
  if (const auto magnets = magnets_that_shut(design, *pose)) add_rows(design, *magnets, out);
  add_current(design, out);
  return out;
}

}  // namespace coilwright::simulation
