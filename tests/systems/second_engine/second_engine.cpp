// What MuJoCo makes of fingers that grip an object, and of a robot that crawls.
// usage: second_engine grip|crawl SCENE.xml TORQUE.csv
//
// Prints JSON, SI. The scene has the bodies; its numeric elements say what is done with them (see second_engine.py).
// A joint whose name ends with a digit is driven by that joint's table of torque per ampere. This knows nothing of
// Coilwright.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exports/torque_table.hpp"

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::exit(1);
}

int id_of(const mjModel* model, mjtObj kind, const std::string& name) {
  const int id = mj_name2id(model, kind, name.c_str());
  if (id < 0) fail("no " + name);
  return id;
}

double number(const mjModel* model, const std::string& name) {
  return model->numeric_data[model->numeric_adr[id_of(model, mjOBJ_NUMERIC, name)]];
}

// A joint with a coil: where it is in the state, and its table.
struct Driven {
  int position{}, rate{};
  const Table* table{};
};

std::vector<Driven> driven_joints(const mjModel* model, const Tables& tables) {
  std::vector<Driven> out;
  for (int j = 0; j < model->njnt; ++j) {
    const std::string name = mj_id2name(model, mjOBJ_JOINT, j);
    if (std::isdigit(static_cast<unsigned char>(name.back())) == 0) continue;
    out.push_back({.position = model->jnt_qposadr[j],
                   .rate = model->jnt_dofadr[j],
                   .table = &tables.at(static_cast<int>(name.back() - '0'))});
  }
  return out;
}

// MuJoCo prints to where the results go, and goes on.
int warnings = 0;
void warn(const char* text) {
  if (warnings++ == 0) std::fprintf(stderr, "MuJoCo: %s\n", text);
}

// All that acts on the bodies besides gravity, springs and contacts: MuJoCo asks for it in every step.
std::function<void(const mjModel*, mjData*)> actions;
void act(const mjModel* model, mjData* data) {
  std::fill_n(data->qfrc_applied, model->nv, 0.0);
  if (actions) actions(model, data);
}

// Friction of all contacts, by the direction of its force.
struct Friction {
  double towards_plus_x{}, towards_minus_x{};
};

// A step, with friction that may depend on its direction, as MuJoCo has it or as Coulomb's.
//
// MuJoCo seeks accelerations a with a - wanted in the dual of the cone of friction: a contact that slides opens, by the
// coefficient of friction times the way that it slides. Coulomb's law is that problem with a normal part that is larger
// by friction times the tangential one (de Saxce and Feng, Math. Comput. Modelling 28 (1998) 225). That of the last
// step is taken, a few steps being what a foot needs to land.
class Stepper {
 public:
  Stepper(const mjModel* model, mjData* data, const Friction& friction)
      : model_(model), data_(data), friction_(friction), coulomb_(number(model, "coulomb") != 0.0) {}

  void step() {
    mj_step1(model_, data_);
    if (coulomb_) lower();
    solve();
    for (int round = 0; round < 8 && turn(); ++round) solve();
    if (coulomb_) keep();
    mj_Euler(model_, data_);
  }

 private:
  void solve() {
    mj_fwdActuation(model_, data_);
    mj_fwdAcceleration(model_, data_);
    mj_fwdConstraint(model_, data_);
  }

  [[nodiscard]] std::vector<mjContact*> rubbing() const {
    std::vector<mjContact*> out;
    for (int c = 0; c < data_->ncon; ++c)
      if (data_->contact[c].dim == 3 && data_->contact[c].efc_address >= 0) out.push_back(data_->contact + c);
    return out;
  }

  // Gives each contact the coefficient of the direction in which its friction acts on the second shape; whether that
  // changes one.
  bool turn() {
    if (friction_.towards_plus_x == friction_.towards_minus_x) return false;
    bool turned = false;
    for (mjContact* contact : rubbing()) {
      std::array<double, 6> force{};
      mj_contactForce(model_, data_, static_cast<int>(contact - data_->contact), force.data());
      const double along_x = force[1] * contact->frame[3] + force[2] * contact->frame[6];
      if (force[0] <= 0.0 || along_x == 0.0) continue;
      const double friction = along_x > 0.0 ? friction_.towards_plus_x : friction_.towards_minus_x;
      if (friction == contact->friction[0]) continue;
      turned = true;
      contact->mu *= friction / contact->friction[0];  // the same, as the cone's own scale has it
      contact->friction[0] = contact->friction[1] = friction;
    }
    return turned;
  }

  void lower() {
    for (const mjContact* contact : rubbing()) {
      const auto last = slid_.find({contact->geom1, contact->geom2});
      double* wanted = data_->efc_aref + contact->efc_address;
      wanted[0] -= last != slid_.end() ? last->second : contact->friction[0] * std::hypot(wanted[1], wanted[2]);
    }
  }

  void keep() {
    slid_.clear();
    std::vector<double> acceleration(static_cast<std::size_t>(data_->nefc));
    if (data_->nefc > 0) mj_mulJacVec(model_, data_, acceleration.data(), data_->qacc);
    for (const mjContact* contact : rubbing()) {
      const double* wanted = data_->efc_aref + contact->efc_address;
      const double* found = acceleration.data() + contact->efc_address;
      slid_[{contact->geom1, contact->geom2}] =
          contact->friction[0] * std::hypot(found[1] - wanted[1], found[2] - wanted[2]);
    }
  }

  const mjModel* model_;
  mjData* data_;
  Friction friction_;
  bool coulomb_;
  std::map<std::pair<int, int>, double> slid_;  // by the two shapes: friction times tangential part, m/s^2
};

using Vector = std::array<double, 3>;

double dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Force and torque of one point dipole on another at `r` from it, and the torque on itself. SI.
struct DipolePull {
  Vector force, torque_on_second, torque_on_first;
};

DipolePull dipole_pull(const Vector& first, const Vector& second, const Vector& r) {
  constexpr double mu0_over_4pi = 1e-7;
  const double distance = mju_norm3(r.data());
  Vector n{};
  for (std::size_t i = 0; i < 3; ++i) n[i] = r[i] / distance;
  const double a = dot(first.data(), n.data());
  const double b = dot(second.data(), n.data());
  const double ab = dot(first.data(), second.data());
  const double strength = 3.0 * mu0_over_4pi / std::pow(distance, 4);
  DipolePull out{};
  Vector field{};
  for (std::size_t i = 0; i < 3; ++i) {
    out.force[i] = strength * (a * second[i] + b * first[i] + (ab - 5.0 * a * b) * n[i]);
    field[i] = mu0_over_4pi * (3.0 * a * n[i] - first[i]) / std::pow(distance, 3);
  }
  mju_cross(out.torque_on_second.data(), second.data(), field.data());
  // Nothing outside holds the two: their couples and that of their forces cancel.
  Vector couple{};
  mju_cross(couple.data(), r.data(), out.force.data());
  for (std::size_t i = 0; i < 3; ++i) out.torque_on_first[i] = -out.torque_on_second[i] - couple[i];
  return out;
}

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
    actions = [this](const mjModel*, mjData*) { apply(); };
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

class Crawling {
 public:
  Crawling(mjModel* model, mjData* data, const Tables& tables)
      : model_(model),
        data_(data),
        stepper_(model, data, {number(model, "friction_forwards"), number(model, "friction_backwards")}),
        joints_(driven_joints(model, tables)),
        forwards_(model->jnt_dofadr[id_of(model, mjOBJ_JOINT, "forwards")]) {
    actions = [this](const mjModel*, mjData*) { apply(); };
  }

  void run() {
    const double period = 1.0 / number(model_, "frequency_Hz");
    const auto settling = static_cast<int>(number(model_, "settling_periods"));
    const auto periods = static_cast<int>(number(model_, "periods"));
    const double duty = number(model_, "duty");
    const double longest = model_->opt.timestep;
    std::vector<double> speeds;
    for (int k = 0; k < settling + periods; ++k) {
      const double from = data_->qpos[forwards_];
      for (const bool closed : {true, false}) {
        closed_ = closed;
        const double time = (closed ? duty : 1.0 - duty) * period;
        const double steps = std::ceil(time / longest - 1e-9);
        model_->opt.timestep = time / steps;  // each switching falls on a step
        for (double i = 0.0; i < steps; i += 1.0) {
          stepper_.step();
          if (k < settling) continue;
          double bending = 0.0;
          for (const Driven& joint : joints_) bending += data_->qpos[joint.position];
          largest_ = std::max(largest_, bending);
        }
      }
      if (k >= settling) speeds.push_back((data_->qpos[forwards_] - from) / period);
    }
    double mean = 0.0;
    for (const double speed : speeds) mean += speed / periods;
    std::printf("{\"speed_m_s\": %.10g, \"largest_bending_rad\": %.10g, \"speeds_m_s\": [", mean, largest_);
    for (std::size_t i = 0; i < speeds.size(); ++i) std::printf("%s%.10g", i == 0 ? "" : ", ", speeds[i]);
    std::printf("]}\n");
  }

 private:
  // Coils of R in parallel behind r on U: R I_c + r sum I = U - what motion induces in the coil, by its own table.
  void apply() {
    if (!closed_) return;
    const double own = number(model_, "coil_resistance_Ohm");
    const double leads = number(model_, "lead_resistance_Ohm");
    std::vector<double> voltages, slopes;
    for (const Driven& joint : joints_) {
      slopes.push_back(joint.table->at(data_->qpos[joint.position]));
      voltages.push_back(number(model_, "voltage_V") - slopes.back() * data_->qvel[joint.rate]);
    }
    const double sum = std::accumulate(voltages.begin(), voltages.end(), 0.0);
    const double total = sum / (own + static_cast<double>(voltages.size()) * leads);
    for (std::size_t c = 0; c < joints_.size(); ++c)
      data_->qfrc_applied[joints_[c].rate] += slopes[c] * (voltages[c] - leads * total) / own;
  }

  mjModel* model_;
  mjData* data_;
  Stepper stepper_;
  std::vector<Driven> joints_;
  int forwards_;
  bool closed_ = false;
  double largest_ = -1.0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(mj_loadXML(argv[2], nullptr, error.data(), error.size()),
                                                           &mj_deleteModel);
  if (model == nullptr) fail(error.data());
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()), &mj_deleteData);
  const Tables tables = tables_of(argv[3]);
  mjcb_control = &act;
  mju_user_warning = &warn;
  mj_forward(model.get(), data.get());
  if (std::string(argv[1]) == "grip")
    Gripping(model.get(), data.get(), tables).run();
  else if (std::string(argv[1]) == "crawl")
    Crawling(model.get(), data.get(), tables).run();
  else
    return 2;
}
