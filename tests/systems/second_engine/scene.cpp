#include "systems/second_engine/scene.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace second_engine {

namespace {

// MuJoCo prints to where the results go, and goes on.
int warnings = 0;
void warn(const char* text) {
  if (warnings++ == 0) std::fprintf(stderr, "MuJoCo: %s\n", text);
}

std::function<void(const mjModel*, mjData*)> actions;
void act(const mjModel* model, mjData* data) {
  std::fill_n(data->qfrc_applied, model->nv, 0.0);
  if (actions) actions(model, data);
}

}  // namespace

void fail(const std::string& what) {
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

void act_by(std::function<void(const mjModel*, mjData*)> what) {
  actions = std::move(what);
  mjcb_control = &act;
  mju_user_warning = &warn;
}

}  // namespace second_engine
