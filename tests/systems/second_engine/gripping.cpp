#include "systems/second_engine/gripping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "systems/second_engine/dipole_pull.hpp"
#include "systems/second_engine/scene.hpp"
#include "systems/second_engine/stepper.hpp"

namespace second_engine {

namespace {

// What contacts of one body do to the object.
struct Touch {
  double normal{}, friction{}, x{}, z{};
};

// Joint angles, and contacts by the body that touches the object: means of 20 ms.
struct Pose {
  std::vector<double> angles;
  std::map<std::string, Touch> contacts;
};

// A finger's magnet as a dipole. Its site is named after the finger: "left_magnet".
struct Dipole {
  std::string finger;  // "left_"
  int site{};
  double moment{};  // A m^2
};

std::vector<Dipole> dipoles(const mjModel* model) {
  const std::string end = "magnet";
  std::vector<Dipole> out;
  for (int s = 0; s < model->nsite; ++s) {
    const std::string name = mj_id2name(model, mjOBJ_SITE, s);
    const std::string finger = name.substr(0, name.size() - end.size());
    out.push_back({.finger = finger, .site = s, .moment = number(model, finger + "moment_Am2")});
  }
  return out;
}

class Gripping {
 public:
  Gripping(mjModel* model, mjData* data, const Tables& tables)
      : model_(model),
        data_(data),
        stepper_(model, data, {number(model, "friction"), number(model, "friction")}),
        joints_(driven_joints(model, tables)),
        object_(id_of(model, mjOBJ_BODY, "object")),
        height_(model->jnt_dofadr[id_of(model, mjOBJ_JOINT, "object_z")]),
        dipoles_(dipoles(model)),
        weight_(model->body_mass[object_] * -model->opt.gravity[2]) {
    act_by([this](const mjModel*, mjData*) { apply(); });
  }

  void run() {
    relax();
    // The open fingers under each other's magnets.
    pull_ = true;
    advance(0.5, [] {});
    close();
    lift();
    print();
  }

 private:
  void apply() {
    for (const Driven& joint : joints_)
      data_->qfrc_applied[joint.rate] += current_ * joint.table->at(data_->qpos[joint.position]);
    data_->qfrc_applied[height_] += weight_ - load_;  // the load is put on as a force, whatever the mass
    if (!pull_) return;
    for (std::size_t second = 0; second < dipoles_.size(); ++second)
      for (std::size_t first = 0; first < second; ++first) add_pull(dipoles_[first], dipoles_[second]);
  }

  void add_pull(const Dipole& first, const Dipole& second) {
    const auto place = [this](const Dipole& dipole) { return data_->site_xpos + 3 * dipole.site; };
    const auto moment = [this](const Dipole& dipole) {
      Vector out{};
      for (std::size_t i = 0; i < 3; ++i)
        out[i] = dipole.moment * data_->site_xmat[9 * static_cast<std::size_t>(dipole.site) + 3 * i + 2];
      return out;
    };
    Vector between{}, back{};
    for (std::size_t i = 0; i < 3; ++i) between[i] = place(second)[i] - place(first)[i];
    const DipolePull pull = dipole_pull(moment(first), moment(second), between);
    for (std::size_t i = 0; i < 3; ++i) back[i] = -pull.force[i];
    mj_applyFT(model_, data_, pull.force.data(), pull.torque_on_second.data(), place(second),
               model_->site_bodyid[second.site], data_->qfrc_applied);
    mj_applyFT(model_, data_, back.data(), pull.torque_on_first.data(), place(first), model_->site_bodyid[first.site],
               data_->qfrc_applied);
  }

  void advance(double time, const std::function<void()>& after) {
    const long steps = std::lround(time / model_->opt.timestep);
    for (long i = 0; i < steps; ++i) {
      stepper_.step();
      after();
    }
  }

  // Hanging fingers come to rest by dampers that are twelve times as strong: near to critical.
  void relax() {
    model_->opt.disableflags |= mjDSBL_CONTACT;
    for (int i = 0; i < model_->nv; ++i) model_->dof_damping[i] *= 12.0;
    load_ = 0.0;
    weight_ = model_->body_mass[object_] * -model_->opt.gravity[2];
    advance(1.5, [] {});
    for (int i = 0; i < model_->nv; ++i) model_->dof_damping[i] /= 12.0;
  }

  // Contacts of the object by the body that touches it, added to a mean over `steps`.
  void add_touches(std::map<std::string, Touch>& to, double steps) const {
    for (int c = 0; c < data_->ncon; ++c) {
      const mjContact& contact = data_->contact[c];
      const bool first = model_->geom_bodyid[contact.geom1] == object_;
      const int other = model_->geom_bodyid[first ? contact.geom2 : contact.geom1];
      if (other == 0 || contact.efc_address < 0) continue;  // the support is the world's
      std::array<double, 6> force{};
      mj_contactForce(model_, data_, c, force.data());
      // The frame's rows are the normal, from the first geom to the second, and two tangents.
      const double sign = first ? -1.0 : 1.0;
      Vector along{}, normal{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 3; ++i) along[axis] += sign * force[i] * contact.frame[3 * i + axis];
        normal[axis] = sign * contact.frame[axis];
      }
      const double pressed = dot(along.data(), normal.data());
      Touch& touch = to[mj_id2name(model_, mjOBJ_BODY, other)];
      touch.normal += pressed / steps;
      // Along the tangent that points upwards.
      touch.friction += (along[2] - pressed * normal[2]) / std::sqrt(1.0 - normal[2] * normal[2]) / steps;
      touch.x = contact.pos[0];
      touch.z = contact.pos[2];
    }
  }

  // Whether all fingers give all the friction upwards that they can: the object begins to slip.
  [[nodiscard]] bool slips() const {
    std::map<std::string, Touch> found;
    add_touches(found, 1.0);
    const double friction = number(model_, "friction");
    return !found.empty() && std::all_of(found.begin(), found.end(), [&](const auto& each) {
      return each.second.normal > 0.0 && each.second.friction > (1.0 - 1e-6) * friction * each.second.normal;
    });
  }

  // Adds the fingers that touch the object.
  void add_touching(std::set<std::string>& fingers) const {
    std::map<std::string, Touch> found;
    add_touches(found, 1.0);
    for (const auto& [body, touch] : found)
      if (touch.normal > 0.0) fingers.insert(body.substr(0, body.find('_')));
  }

  [[nodiscard]] double finger_energy() const {
    std::vector<double> momentum(static_cast<std::size_t>(model_->nv));
    mj_mulM(model_, data_, momentum.data(), data_->qvel);
    double out = 0.0;
    for (const Driven& joint : joints_)
      out += 0.5 * momentum[static_cast<std::size_t>(joint.rate)] * data_->qvel[joint.rate];
    return out;
  }

  // The current is on and the object stands on its smooth support, until the fingers keep still for 20 ms; at most 1 s.
  void close() {
    model_->opt.disableflags &= ~mjDSBL_CONTACT;
    current_ = number(model_, "current_A");
    load_ = weight_;
    std::set<std::string> touched;
    double still = 0.0;
    for (double time = model_->opt.timestep; time <= 1.0 && still <= 0.02; time += model_->opt.timestep) {
      stepper_.step();
      add_touching(touched);
      const bool all = touched.size() == dipoles_.size();
      if (all && closing_time_ < 0.0) closing_time_ = time;
      still = all && finger_energy() < 1e-8 ? still + model_->opt.timestep : 0.0;
    }
    const double steps = std::round(0.02 / model_->opt.timestep);
    advance(0.02, [&] { add_touches(closed_.contacts, steps); });
    closed_.angles = angles();
  }

  [[nodiscard]] std::vector<double> angles() const {
    std::vector<double> out;
    for (const Driven& joint : joints_) out.push_back(data_->qpos[joint.position]);
    return out;
  }

  // The support is gone; the load grows for 0.3 s, rests for 0.2 s, and grows on until the object begins to slip.
  void lift() {
    model_->geom_conaffinity[id_of(model_, mjOBJ_GEOM, "support")] = 0;
    const double step = model_->opt.timestep;
    const double whole = number(model_, "load_N");
    const double start = data_->qpos[height_];
    const double steps = std::round(0.02 / step);
    for (double time = step; load_ < 10.0 * whole && !slips(); time += step) {
      load_ = whole / 0.3 * (std::min(time, 0.3) + std::max(0.0, time - 0.5));
      stepper_.step();
      if (time > 0.48 && time <= 0.5) add_touches(held_.contacts, steps);
      if (!held_.angles.empty() || time <= 0.5) continue;
      settling_ = start - data_->qpos[height_];
      sinking_ = -data_->qvel[height_];
      held_.angles = angles();
    }
  }

  static void print(const char* name, const Pose& pose, const char* end) {
    std::printf("\"%s\": {\"angles_rad\": [", name);
    for (std::size_t i = 0; i < pose.angles.size(); ++i) std::printf("%s%.10g", i == 0 ? "" : ", ", pose.angles[i]);
    std::printf("], \"contacts\": {");
    const char* separator = "";
    for (const auto& [body, touch] : pose.contacts) {
      std::printf("%s\"%s\": {\"normal_N\": %.10g, \"friction_N\": %.10g, \"x_m\": %.10g, \"z_m\": %.10g}", separator,
                  body.c_str(), touch.normal, touch.friction, touch.x, touch.z);
      separator = ", ";
    }
    std::printf("}}%s\n", end);
  }

  void print() const {
    std::printf(
        "{\"closing_time_s\": %.10g, \"slipping_load_N\": %.10g, \"settling_m\": %.10g, \"sinking_m_s\": %.10g,\n",
        closing_time_, load_, settling_, sinking_);
    print("closed", closed_, ",");
    print("held", held_, "}");
  }

  mjModel* model_;
  mjData* data_;
  Stepper stepper_;
  std::vector<Driven> joints_;
  int object_, height_;
  std::vector<Dipole> dipoles_;
  double weight_;
  bool pull_ = false;
  double current_ = 0.0;
  double load_ = 0.0;
  double closing_time_ = -1.0;
  double settling_ = 0.0;
  double sinking_ = 0.0;
  Pose closed_, held_;
};

}  // namespace

void grip(mjModel* model, mjData* data, const Tables& tables) {
  Gripping(model, data, tables).run();
}

}  // namespace second_engine
