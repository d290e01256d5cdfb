#include "systems/gripper/scene.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "coilwright/simulation/equilibrium.hpp"
#include "systems/gripper/placement.hpp"
#include "systems/hinge_slopes.hpp"

namespace coilwright::systems::gripper {
namespace {

using Eigen::Vector2d;
using mechanics::closed_gap;
using mechanics::Contact;
using mechanics::CoordinateVector;
using mechanics::JointVector;

// The fingers' magnets are taken anew where something has moved so far, m: it changes their force by 2 % at 40 mm; and
// after this time, s, if it has moved at all since: by so much that their force changes by 2e-4.
constexpr double pull_way = 2e-4;
constexpr double pull_time = 1e-2;
constexpr double least_pull_way = 2e-6;

// After a change of what acts, s, and how much longer than the one before a step may be.
constexpr double first_step = 2e-4;
constexpr double step_growth = 1.3;
// Of a finger whose joints close or are shut, s: their faces ring at a kilohertz, and longer steps rattle on them for
// good.
constexpr double face_step = 2e-4;
constexpr double still_rate = 1e-3;     // rad/s: slower, faces that press are at rest
constexpr double shortest_step = 2e-6;  // s: at 50 m/s nothing is as it should be, and no time is to stand still

// A contact whose rows are those of the object alone, at `position`.
Contact of_object(Eigen::Index joints, const ObjectPose& pose, const Vector2d& position, const Vector2d& normal) {
  const Vector2d tangent(-normal.y(), normal.x());
  const Vector2d arm = position - pose.centre;
  const Vector2d turning(-arm.y(), arm.x());
  Contact out{.normal = CoordinateVector::Zero(2 * joints + 3), .tangent = CoordinateVector::Zero(2 * joints + 3)};
  out.normal.tail<3>() << normal, normal.dot(turning);
  out.tangent.tail<3>() << tangent, tangent.dot(turning);
  return out;
}

// What may be missed where a finger lands at `along`, m: near a joint the same way is a larger angle of it, and torque
// curves are steep. At 2.4 mm 10 um are a quarter of a degree, and 4 % of the torque.
double landing_way_at(double along) {
  constexpr double angle = 3e-4;    // rad
  constexpr double least = 2.5e-7;  // m
  return std::clamp(angle * along, least, mechanics::landing_way);
}

// From each joint to the tip of the straight finger, m.
JointVector reaches_of(const actuator::Model& finger) {
  JointVector out(finger.joints());
  double beyond = std::hypot(finger.tip().along, finger.tip().offset);
  for (int j = finger.joints() - 1; j >= 0; --j) {
    out[j] = beyond;
    if (j > 0) beyond += finger.chain().link(j - 1).length;
  }
  return out;
}

}  // namespace

Scene::Scene(const Gripper& gripper, const Object& object, double current)
    : gripper_(gripper),
      object_(object),
      joints_(gripper.finger().joints()),
      reaches_(reaches_of(gripper.finger())),
      support_height_(object.centre.y() - object.half_height()),
      position_(CoordinateVector::Zero(2 * joints_ + 3)),
      velocity_(CoordinateVector::Zero(2 * joints_ + 3)),
      pull_way_(std::numeric_limits<double>::infinity()),
      pull_age_(0.0) {
  const actuator::Model& finger = gripper.finger();
  const auto rest = simulation::find_equilibrium(finger, finger.all_coils(current), JointVector::Zero(joints_));
  if (!rest) throw std::runtime_error("gripper: the fingers come to no rest under their opening current");
  position_.head(joints_) = *rest;
  position_.segment(joints_, joints_) = *rest;
  position_.segment<2>(2 * joints_) = object.centre;
  require_apart();
}

void Scene::require_apart() const {
  for (int f = 0; f < 2; ++f)
    for (const FacePoint& point :
         face_points(gripper_, f, gripper_.finger().chain().frames(angles(f)), object_, object()))
      if (point.gap <= closed_gap)
        throw NoRoom(closed_gap - point.gap,
                     fmt::format("object must leave the open fingers free; got {:.3g} mm of overlap with the {} finger",
                                 -1e3 * point.gap, f == 0 ? "left" : "right"));
}

ObjectPose Scene::object() const {
  return {.centre = position_.segment<2>(2 * joints_), .angle = position_[2 * joints_ + 2]};
}

bool Scene::touches(int finger) const {
  for (const Touch& touch : touches_)
    if (touch.point.finger == finger && touch.normal > 0.0) return true;
  return false;
}

double Scene::lifting_force() const {
  double out = 0.0;
  for (const Touch& touch : touches_)
    out += touch.normal * touch.point.normal.y() + touch.tangential * touch.point.normal.x();
  return out;
}

double Scene::finger_energy() const {
  double out = 0.0;
  for (int f = 0; f < 2; ++f)
    out += gripper_.finger().chain().kinetic_energy(angles(f), velocity_.segment(f * joints_, joints_));
  return out;
}

void Scene::add_fingers(const CoordinateVector& position, const CoordinateVector& velocity, const Actions& actions,
                        double duration, mechanics::MiddleOfStep& out) const {
  const actuator::Model& finger = gripper_.finger();
  for (int f = 0; f < 2; ++f) {
    const Eigen::Index first = f * joints_;
    const JointVector angles = position.segment(first, joints_);
    const JointVector rates = velocity.segment(first, joints_);
    auto mass = out.mass.block(first, first, joints_, joints_);
    mass = finger.chain().mass_matrix(angles);
    mass.diagonal() += hinge_slopes(finger, angles, rates).implicit_inertia(duration);
    out.force.segment(first, joints_) = finger.torques(angles, rates, finger.all_coils(actions.current)) -
                                        finger.chain().bias_torques(angles, rates) +
                                        (f == 0 ? pull_.left : pull_.right);
  }
}

void Scene::add_contacts(const CoordinateVector& position, const CoordinateVector& velocity, double duration,
                         const Actions& actions, mechanics::MiddleOfStep& out) {
  const ObjectPose pose{.centre = position.segment<2>(2 * joints_), .angle = position[2 * joints_ + 2]};
  for (int f = 0; f < 2; ++f) {
    const mechanics::LinkFrames frames = gripper_.finger().chain().frames(position.segment(f * joints_, joints_));
    const Placement here = placement(gripper_.mounting(), f);
    double& nearest = gaps_[static_cast<std::size_t>(f)];
    nearest = std::numeric_limits<double>::infinity();
    for (const FacePoint& point : face_points(gripper_, f, frames, object_, pose)) {
      nearest = std::min(nearest, point.gap);
      // Finger and object come nearer by twice longest_way in a step at most.
      if (point.gap > 4.0 * longest_way) continue;
      Contact contact = of_object(joints_, pose, point.position, point.normal);
      const mechanics::PointJacobian moved = here.jacobian(gripper_.finger().chain().jacobian(point.on_finger, frames));
      const Vector2d tangent(-point.normal.y(), point.normal.x());
      contact.normal.segment(f * joints_, joints_) = -(moved.transpose() * point.normal);
      contact.tangent.segment(f * joints_, joints_) = -(moved.transpose() * tangent);
      contact.friction = {.along = object_.friction, .against = object_.friction};
      out.lands = out.lands || mechanics::lands_too_fast(point.gap, -contact.normal.dot(velocity), duration,
                                                         landing_way_at(point.on_finger.along));
      if (point.gap > closed_gap) continue;
      out.contacts.push_back(std::move(contact));
      closed_.push_back(point);
    }
  }
  if (!actions.support) return;
  // A smooth plane under the lowest points of the object.
  const double half_width = object_.has_flat_sides() ? 0.5 * object_.width : 0.0;
  const std::array<double, 2> feet{-half_width, half_width};
  for (std::size_t i = 0; i < (half_width > 0.0 ? 2U : 1U); ++i) {
    const Vector2d foot =
        object_.has_flat_sides()
            ? Vector2d(pose.centre + Eigen::Rotation2Dd(pose.angle) * Vector2d(feet[i], -object_.half_height()))
            : Vector2d(pose.centre - Vector2d(0.0, object_.half_height()));
    if (foot.y() - support_height_ <= closed_gap) out.contacts.push_back(of_object(joints_, pose, foot, {0.0, 1.0}));
  }
}

mechanics::MiddleOfStep Scene::middle(const CoordinateVector& position, const CoordinateVector& velocity,
                                      double duration, const Actions& actions) {
  const Eigen::Index n = 2 * joints_ + 3;
  mechanics::MiddleOfStep out{
      .mass = mechanics::CoordinateMatrix::Zero(n, n), .force = CoordinateVector::Zero(n), .contacts = {}};
  add_fingers(position, velocity, actions, duration, out);
  out.mass(n - 3, n - 3) = out.mass(n - 2, n - 2) = object_.mass;
  out.mass(n - 1, n - 1) = object_.inertia();
  closed_.clear();
  if (actions.apart) return out;
  out.force[n - 2] = -actions.load;
  add_contacts(position, velocity, duration, actions, out);
  return out;
}

double Scene::fastest() const {
  double out = 0.0;
  for (int f = 0; f < 2; ++f) out = std::max(out, velocity_.segment(f * joints_, joints_).cwiseAbs().dot(reaches_));
  const double radius = 0.5 * std::hypot(object_.width, 2.0 * object_.half_height());
  return std::max(out, velocity_.segment<2>(2 * joints_).norm() + std::abs(velocity_[2 * joints_ + 2]) * radius);
}

bool Scene::joints_close(double duration) const {
  const std::vector<actuator::Hinge>& hinges = gripper_.finger().hinges();
  for (Eigen::Index i = 0; i < 2 * joints_; ++i) {
    const double open = position_[i] - hinges[static_cast<std::size_t>(i % joints_)].contact.closing_angle;
    const double rate = std::abs(velocity_[i]);
    if (rate > still_rate && open < rate * duration) return true;
  }
  return false;
}

double Scene::duration_of_step(const Actions& actions, double longest, double speed) {
  // What is let go or switched on is at rest, and fast after a few steps.
  const bool begins = !actions_ || actions_->current != actions.current || actions_->support != actions.support;
  actions_ = actions;
  last_step_ = std::min(longest, begins ? first_step : step_growth * last_step_);
  if (speed * last_step_ > longest_way) last_step_ = std::max(longest_way / speed, shortest_step);
  if (last_step_ > face_step && joints_close(last_step_)) last_step_ = face_step;
  return last_step_;
}

void Scene::pull_by_magnets(double way, double duration) {
  if (pull_way_ >= pull_way || (pull_age_ >= pull_time && pull_way_ >= least_pull_way)) {
    pull_ = gripper_.magnet_torques(angles(0), angles(1));
    pull_way_ = pull_age_ = 0.0;
  }
  pull_way_ += way;
  pull_age_ += duration;
}

double Scene::advance(const Actions& actions, double longest) {
  const double speed = fastest();
  const double duration = duration_of_step(actions, longest, speed);
  pull_by_magnets(speed * duration, duration);
  touches_.clear();
  mechanics::advance_to_landings(
      position_, velocity_, duration,
      [&](const CoordinateVector& at, const CoordinateVector& rates, double part) {
        return middle(at, rates, part, actions);
      },
      [&](const mechanics::MoreauStep& step, double /*part*/) {
        for (std::size_t i = 0; i < closed_.size(); ++i)
          touches_.push_back({.point = closed_[i],
                              .normal = step.impulses[i].normal / duration,
                              .tangential = step.impulses[i].tangential / duration});
      });
  return duration;
}

}  // namespace coilwright::systems::gripper
