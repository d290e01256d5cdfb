#include "coilwright/systems/gripper/quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "coilwright/actuator/cost.hpp"
#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/systems/gripper/grasp.hpp"
#include "coilwright/systems/gripper/heat_of_hold.hpp"
#include "coilwright/systems/gripper/placement_tolerance.hpp"
#include "systems/tried.hpp"

namespace coilwright::systems::gripper {
namespace {

using actuator::HeldCases;
using simulation::DesignView;
using simulation::NoValue;
using simulation::ResultQuantity;
using simulation::Settings;
using simulation::SharedResult;
using Value = std::optional<double>;
using TaskOf = std::function<GripperTask(const Settings&)>;

constexpr auto no_grasp = "the gripper cannot be tried on the object";
constexpr auto no_reach = "a finger does not reach the object";
constexpr auto runaway = "the current is at or beyond that of a thermal runaway";

GraspTask grasp_task(const GripperTask& task, double current) {
  return {.current = current, .open_current = task.open_current, .acceleration = task.acceleration};
}

// A gripper that was tried.
struct Tried {
  GripperTask task;
  Gripper gripper;
  Grasp grasp;
};

// Where open fingers leave no room, a design is as far from a grasp as that is.
template <class Work>
auto tried_with(const GripperTask& task, const Work& work) -> Try<std::invoke_result_t<const Work&>> {
  return tried([&]() -> Try<std::invoke_result_t<const Work&>> { return work(); },
               [&](const std::exception& failure) {
                 const auto* none = dynamic_cast<const NoRoom*>(&failure);
                 return none == nullptr ? 1.0 : 1.0 + none->overlap() / task.object.width;
               });
}

Try<Tried> try_grasp(const TaskOf& task_of, const DesignView& design) {
  const GripperTask task = task_of(simulation::settings_of(design));
  return tried_with(task, [&] {
    Gripper gripper(design.design, task.mounting);
    Grasp found = grasp(gripper, task.object, grasp_task(task, design.point.current));
    return Tried{.task = task, .gripper = std::move(gripper), .grasp = std::move(found)};
  });
}

// The smaller of the two fingers' pressing forces, N.
double normal_force(const Grasp& grasp) {
  std::array<double, 2> sum{};
  for (const GraspContact& contact : grasp.contacts) sum[static_cast<std::size_t>(contact.finger)] += contact.normal;
  return std::min(sum[0], sum[1]);
}

// All that the quantities read, made for the first of them.
class Results {
 public:
  explicit Results(const TaskOf& task)
      : grasp_([task](const DesignView& design) { return try_grasp(task, design); }),
        heat_(of_try(grasp_,
                     [](const Tried& done, const DesignView& design) {
                       return heat_of_hold(design.design, done.gripper, done.grasp, design.point);
                     })),
        least_(of_try(grasp_,
                      [](const Tried& done, const DesignView& design) -> Value {
                        const GripperTask& own = done.task;
                        const double most =
                            own.most_current > 0.0 ? own.most_current : operating_current_limit(design.design);
                        const auto least = tried_with(
                            own, [&] { return least_current(done.gripper, own.object, grasp_task(own, most), most); });
                        const auto* value = std::get_if<Value>(&least);
                        return value == nullptr ? std::nullopt : *value;
                      })),
        tolerance_(of_try(grasp_, [](const Tried& done, const DesignView& design) -> Value {
          if (!done.grasp.holds) return 0.0;
          const auto off = tried_with(done.task, [&] {
            return length_tolerance(design.design, done.gripper, done.task.object,
                                    grasp_task(done.task, design.point.current));
          });
          const auto* found = std::get_if<double>(&off);
          return found == nullptr ? Value() : Value(*found * 1e3);
        })) {}

  ResultQuantity of_grasp(std::string name, std::string meaning, double scale,
                          const std::function<Value(const Tried&)>& value, const std::string& absence = {}) const {
    return with_reason({.name = std::move(name),
                        .meaning = std::move(meaning),
                        .scale = scale,
                        .value = of_try(grasp_, [value](const Tried& done, const DesignView&) { return value(done); }),
                        .absence = absence.empty() ? std::string(no_grasp) : absence,
                        .pose = HeldCases::gripping});
  }

  ResultQuantity of_heat(std::string name, std::string meaning, double scale,
                         const std::function<Value(const simulation::Heat&, const DesignView&)>& value,
                         std::string absence) const {
    return with_reason({.name = std::move(name),
                        .meaning = std::move(meaning),
                        .scale = scale,
                        .value =
                            [heat = heat_, value](const DesignView& design) {
                              const auto found = heat.of(design);
                              return found->has_value() ? value(**found, design) : std::nullopt;
                            },
                        .absence = std::move(absence),
                        .pose = HeldCases::gripping,
                        .in_every_use = true});
  }

  ResultQuantity placement_tolerance_quantity() const {
    return with_reason({.name = "grip_placement_tolerance_mm",
                        .meaning = "how far height and width of the object and spacing of the palm may be off, each "
                                   "way, and it is still held; "
                                   "tried up to 2; 0 where it is not held as planned",
                        .scale = 1.0,
                        .value = [tolerance = tolerance_](const DesignView& design) { return *tolerance.of(design); },
                        .absence = no_grasp,
                        .pose = HeldCases::gripping});
  }

  ResultQuantity least_current_quantity() const {
    return with_reason({.name = "grip_least_current_A",
                        .meaning = "least current that holds the object, to 0.5 %",
                        .scale = 1.0,
                        .value = [least = least_](const DesignView& design) { return *least.of(design); },
                        .absence = "no current up to the one allowed holds the object",
                        .pose = HeldCases::gripping});
  }

 private:
  // Where there was no grasp that is the reason; otherwise the quantity's own, and how far from holding it is.
  ResultQuantity with_reason(ResultQuantity quantity) const {
    quantity.why_absent = [grasp = grasp_, own = quantity.absence](const DesignView& design) -> NoValue {
      const auto found = grasp.of(design);
      if (const auto* none = std::get_if<NoValue>(found.get())) return *none;
      const Tried& done = std::get<Tried>(*found);
      return {.reason = own, .infeasibility = 1.0 + std::max(0.0, -holding_margin(done.grasp, done.task.object))};
    };
    return quantity;
  }

  SharedResult<Try<Tried>> grasp_;
  SharedResult<std::optional<simulation::Heat>> heat_;
  SharedResult<Value> least_;
  SharedResult<Value> tolerance_;
};

// What needs no grasp.
ResultQuantity of_design(std::string name, std::string meaning, double scale, ResultQuantity::Value value) {
  return {.name = std::move(name), .meaning = std::move(meaning), .scale = scale, .value = std::move(value)};
}

}  // namespace

std::vector<ResultQuantity> gripper_quantities(const TaskOf& task) {
  const Results results(task);
  // The same in all designs: a whole number is no variable.
  const int fingers = task({}).mounting.fingers;
  return {
      of_design("gripper_mass_g", "mass of all fingers without palm and wires", 140.0,
                [fingers](const DesignView& d) -> Value { return 1e3 * fingers * d.performance.mass; }),
      of_design(
          "gripper_cost_USD", "cost of all fingers, driver and supply", 44.0,
          [fingers](const DesignView& d) -> Value { return actuator::gripper_cost(d.performance.cost, fingers); }),
      of_design("gripper_friction", "coefficient of friction between object and fingers that is assumed", 1.0,
                [task](const DesignView& d) -> Value { return task(simulation::settings_of(d)).object.friction; }),
      results.of_grasp("grip_margin",
                       "load at which the object slips over its load, less one; below -1 a finger does not reach it",
                       1.0, [](const Tried& done) -> Value { return holding_margin(done.grasp, done.task.object); }),
      results.placement_tolerance_quantity(),
      results.of_grasp("grip_load_N", "weight of the object and what its acceleration adds", 2.0,
                       [](const Tried& done) -> Value { return done.grasp.load; }),
      results.of_grasp("grip_capacity_N", "load at which the object slips; ten times its load where more holds", 2.0,
                       [](const Tried& done) -> Value { return done.grasp.capacity; }),
      results.of_grasp("grip_normal_force_N",
                       "force with which the weaker finger presses in the hold, or before it where there is none", 1.0,
                       [](const Tried& done) -> Value { return normal_force(done.grasp); }),
      results.of_grasp(
          "grip_closing_time_ms", "from the current to the touch of the later finger", 30.0,
          [](const Tried& done) -> Value {
            return done.grasp.both_touched ? Value(done.grasp.closing_time * 1e3) : Value();
          },
          no_reach),
      results.of_grasp("grip_magnet_force_N", "largest force between magnets of different fingers in the hold", 1.0,
                       [](const Tried& done) -> Value { return done.grasp.magnet_force; }),
      results.of_heat(
          "grip_continuous_current_A", "current that neither coils nor magnets forbid for good in the pose of the hold",
          1.0, [](const simulation::Heat& heat, const DesignView&) -> Value { return heat.current_for_good(); },
          runaway),
      results.of_heat(
          "grip_thermal_load", "rms current divided by grip_continuous_current_A", 1.0,
          [](const simulation::Heat& heat, const DesignView& d) -> Value {
            const double allowed = heat.current_for_good();
            return allowed > 0.0 ? Value(std::abs(d.point.current) * std::sqrt(d.point.duty) / allowed) : Value();
          },
          "the surroundings are as hot as a limit already"),
      results.of_heat(
          "grip_time_to_limit_s", "time from cold, current on, until a part is at its limit in the pose of the hold",
          100.0, [](const simulation::Heat& heat, const DesignView&) { return heat.time_to_limit; },
          "the current may be held for good"),
      results.least_current_quantity()};
}

}  // namespace coilwright::systems::gripper
