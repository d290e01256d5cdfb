#include "coilwright/systems/gripper/grasp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "systems/check.hpp"
#include "systems/gripper/scene.hpp"

namespace coilwright::systems::gripper {
namespace {

// Times of the programme, s.
constexpr double settle_time = 0.5;   // at most, until the open fingers are at rest under each other's magnets
constexpr double close_time = 1.0;    // at most, until both fingers hold still on the object
constexpr double ramp_time = 0.3;     // in which the load is put on
constexpr double hold_time = 0.2;     // with the whole load
constexpr double record_time = 0.02;  // at its end, over which the forces are the mean
constexpr double end_of_hold = ramp_time + hold_time;
// What is left of a part of the programme that is not worth a step.
constexpr double shortest_rest = 1e-9;

// An object that sinks faster than this is slipping, m/s: a soft grip settles by millimetres in the 0.3 s of the ramp.
constexpr double slipping = 0.02;
// One that sinks slower than this at the end of the hold is at rest.
constexpr double at_rest = 2e-3;
// Lost for good, m/s.
constexpr double lost = 0.1;
constexpr double most_load = 10.0;  // of the task's

// Over which what the fingers carry is the mean, s: impulses differ from step to step.
constexpr double carrying_time = 2e-3;

// Fingers with less than this are still, J: a tip of 20 g at 1 mm/s.
constexpr double still_energy = 1e-8;
// Fingers that were never faster than this on their way are where they rest, J: they missed it by micrometres.
constexpr double resting_energy = 1e-12;

// What the fingers carried of late. Of an object that slips that is what they can, and not the load: that has grown by
// a ninth of the object's weight since it began to slip, however little of it the fingers bear.
class Carried {
 public:
  // N, over a step of `duration`, s.
  void add(double duration, double force) {
    steps_.push_back({duration, force});
    duration_ += duration;
    while (duration_ - steps_.front().first >= carrying_time) {
      duration_ -= steps_.front().first;
      steps_.pop_front();
    }
  }
  // N, over carrying_time and what is left of its first step.
  [[nodiscard]] double mean() const {
    double impulse = 0.0;
    for (const auto& [duration, force] : steps_) impulse += duration * force;
    return impulse / duration_;
  }

 private:
  std::deque<std::pair<double, double>> steps_;
  double duration_{};
};

void check(const GraspTask& task) {
  require(true, "current", "finite", task.current);
  require(true, "open_current", "finite", task.open_current);
  require(task.acceleration >= 0.0, "acceleration", "finite and >= 0", task.acceleration);
  require(task.step > 0.0 && task.step <= 2e-3, "step", "> 0 and <= 2 ms", task.step);
}

class Programme {
 public:
  Programme(const Gripper& gripper, const Object& object, const GraspTask& task)
      : gripper_(gripper), object_(object), task_(task), scene_(gripper, object, task.open_current) {
    out_.load = object.mass * (gripper.gravity() + task.acceleration);
    out_.closing_time = std::numeric_limits<double>::infinity();
  }

  Grasp run() {
    settle();
    close();
    record_closed();
    if (out_.both_touched) lift();
    return std::move(out_);
  }

 private:
  // Only where they come to rest is asked for, and not how long they would swing: they are halted wherever they are
  // fastest, near their rest (kinetic damping).
  void settle() {
    double before = 0.0;
    for (double time = 0.0; time < settle_time;) {
      time += scene_.advance({.current = task_.open_current, .apart = true}, task_.step);
      scene_.require_apart();
      const double energy = scene_.finger_energy();
      if (energy < before) {
        if (before < resting_energy) break;
        scene_.halt();
      }
      before = energy < before ? 0.0 : energy;
    }
  }

  // Until both fingers have touched and hold still.
  void close() {
    const double weight = object_.mass * gripper_.gravity();
    bool left = false;
    bool right = false;
    double still = 0.0;
    std::array<double, 2> nearest{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (double time = 0.0; time < close_time;) {
      const double step = scene_.advance({.current = task_.current, .load = weight, .support = true}, task_.step);
      time += step;
      left = left || scene_.touches(0);
      right = right || scene_.touches(1);
      for (int f = 0; f < 2; ++f)
        nearest[static_cast<std::size_t>(f)] = std::min(nearest[static_cast<std::size_t>(f)], scene_.gap(f));
      if (left && right && !out_.both_touched) {
        out_.both_touched = true;
        out_.closing_time = time;
      }
      still = out_.both_touched && scene_.finger_energy() < still_energy ? still + step : 0.0;
      if (still > record_time) break;
    }
    if (!out_.both_touched) out_.missing = std::max(0.0, std::max(left ? 0.0 : nearest[0], right ? 0.0 : nearest[1]));
  }

  // Adds what touched in the last step to a mean of which it is this share.
  void add_contacts(double share) {
    for (const Scene::Touch& touch : scene_.touches()) {
      if (touch.normal <= 0.0) continue;
      // One entry for each face that presses.
      GraspContact& mean = contacts_[{touch.point.finger, touch.point.on_finger.link}];
      mean.finger = touch.point.finger;
      mean.link = touch.point.on_finger.link;
      mean.along = touch.point.on_finger.along;
      mean.position = touch.point.position;
      mean.normal += share * touch.normal;
      // Along +tangent, which a finger's normal towards +x turns upwards and one towards -x downwards.
      mean.friction += (touch.point.normal.x() > 0.0 ? 1.0 : -1.0) * share * touch.tangential;
    }
  }

  void take_contacts() {
    out_.left = scene_.angles(0);
    out_.right = scene_.angles(1);
    out_.magnet_force = scene_.magnet_force();
    out_.contacts.clear();
    for (const auto& [where, contact] : contacts_) out_.contacts.push_back(contact);
    contacts_.clear();
  }

  // Still on its support, with its weight.
  void record_closed() {
    const Actions actions{.current = task_.current, .load = object_.mass * gripper_.gravity(), .support = true};
    for (double left = record_time; left > shortest_rest;) {
      const double step = scene_.advance(actions, std::min(task_.step, left));
      left -= step;
      add_contacts(step / record_time);
    }
    take_contacts();
  }

  // The load grows, rests for the hold, and grows on until the object is lost.
  void lift() {
    const double start = scene_.object().centre.y();
    constexpr double record_from = end_of_hold - record_time;
    Carried carried;
    double held = 0.0;
    bool judged = false;
    for (double time = 0.0;;) {
      // What is put on within the longest step is there from its start; steps end where the record begins and the hold
      // does.
      const double until = time < record_from ? record_from : (judged ? time + task_.step : end_of_hold);
      const double longest = std::min(task_.step, until - time);
      const double step = scene_.advance({.current = task_.current, .load = load_at(time + longest)}, longest);
      time = until - time - step < shortest_rest ? until : time + step;
      const double sinking = -scene_.object_velocity().y();
      carried.add(step, scene_.lifting_force());
      if (sinking < slipping) held = carried.mean();
      if (!judged && time > record_from) add_contacts(step / record_time);
      if (!judged && time >= end_of_hold) {
        judged = true;
        out_.holds = std::abs(sinking) < at_rest && scene_.touches(0) && scene_.touches(1);
        if (!out_.holds) break;
        out_.settling = start - scene_.object().centre.y();
        take_contacts();
        if (!task_.find_capacity) break;
      }
      if (sinking > lost) break;
      if (load_at(time) >= most_load * out_.load) {
        out_.capacity_is_bound = true;
        break;
      }
    }
    // What holds its whole load is carried; the mean over a few steps may say a percent less.
    out_.capacity = out_.holds ? std::max(held, out_.load) : held;
  }

  // At a time after the support was taken away, N.
  [[nodiscard]] double load_at(double time) const {
    return out_.load / ramp_time * (std::min(time, ramp_time) + std::max(0.0, time - end_of_hold));
  }

  const Gripper& gripper_;
  const Object& object_;
  const GraspTask& task_;
  Scene scene_;
  Grasp out_{};
  std::map<std::pair<int, int>, GraspContact> contacts_{};
};

// The margin of an object that creeps away under its whole load: not held, and as near to it as a search may see.
constexpr double creeping = -0.01;
// The farthest that a finger is said to be from the object, in widths of it: beyond, no face looks at it.
constexpr double out_of_sight = 10.0;

// The least of (0, most] for which `holds`, to 0.5 %; nothing if `most` does not.
std::optional<double> least(double most, const std::function<bool(double)>& holds) {
  if (!holds(most)) return std::nullopt;
  double below = 0.0;
  double above = most;
  while (above - below > 0.005 * above) {
    const double middle = 0.5 * (below + above);
    (holds(middle) ? above : below) = middle;
    if (above < 1e-4 * most) return 0.0;
  }
  return above;
}

}  // namespace

Grasp grasp(const Gripper& gripper, const Object& object, const GraspTask& task) {
  check(object);
  check(task);
  const int fingers = gripper.mounting().fingers;
  if (fingers > 2 && !object.is_round_about_the_axis())
    throw std::invalid_argument(
        fmt::format("object must be a sphere or an upright_cylinder with its centre on the gripper's axis for more "
                    "than two fingers; got a {} with its centre at {:.4g} mm",
                    name_of(object.shape), object.centre.x() * 1e3));
  // Fingers that all do the same carry the same: any two of them hold their share as two alone do, each pushed by all
  // others' magnets.
  const double pairs = 0.5 * fingers;
  Object share = object;
  share.mass /= pairs;
  Grasp out = Programme(gripper, share, task).run();
  out.load *= pairs;
  out.capacity *= pairs;
  const double overlap = std::max(gripper.overlap_of_neighbours(out.left), gripper.overlap_of_neighbours(out.right));
  if (overlap > 0.0)
    throw NoRoom(
        overlap,
        fmt::format(
            "the {} fingers must leave each other room around the object; got {:.3g} mm of overlap between neighbours",
            fingers, overlap * 1e3));
  return out;
}

double holding_margin(const Grasp& grasp, const Object& object) {
  if (!grasp.both_touched) return -1.0 - std::min(grasp.missing / object.width, out_of_sight);
  const double margin = grasp.margin() - 1.0;
  return grasp.holds ? std::max(0.0, margin) : std::min(margin, creeping);
}

std::optional<double> least_current(const Gripper& gripper, const Object& object, GraspTask task, double most) {
  task.find_capacity = false;
  return least(most, [&](double current) {
    task.current = current;
    return grasp(gripper, object, task).holds;
  });
}

std::optional<double> least_friction(const Gripper& gripper, Object object, const GraspTask& task, double most) {
  GraspTask quick = task;
  quick.find_capacity = false;
  return least(most, [&](double friction) {
    object.friction = friction;
    return grasp(gripper, object, quick).holds;
  });
}

}  // namespace coilwright::systems::gripper
