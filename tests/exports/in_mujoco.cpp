// What MuJoCo makes of a file: its equilibrium, its equation of motion about it, and its motion in the three seconds
// after a step of the current from rest. usage: in_mujoco MODEL TORQUE.csv CURRENT_A [JOINTS.csv]
//
// Prints JSON, SI. The torque of a joint is the current times the table's, by straight lines between the rows. A model
// in URDF has no springs: those of JOINTS.csv are put on its joints. This knows nothing of Coilwright.
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "torque_table.hpp"

namespace {

// Joints are numbered from 1 in files; their names are joint1, joint2 and so on.
int dof_of(const mjModel* model, int joint) {
  const std::string name = "joint" + std::to_string(joint);
  const int id = mj_name2id(model, mjOBJ_JOINT, name.c_str());
  if (id < 0) {
    std::fprintf(stderr, "no %s\n", name.c_str());
    std::exit(1);
  }
  return model->jnt_dofadr[id];
}

// What drives the model: MuJoCo asks for it at every stage of a step.
struct Drive {
  Tables tables;
  double current = 0.0;
};
Drive drive;

// By the motor of the joint, or on the joint itself where the file has no motors.
void apply(const mjModel* model, mjData* data) {
  for (const auto& [joint, table] : drive.tables) {
    const int dof = dof_of(model, joint);
    const int motor = mj_name2id(model, mjOBJ_ACTUATOR, ("joint" + std::to_string(joint) + "_torque").c_str());
    (motor < 0 ? data->qfrc_applied[dof] : data->ctrl[motor]) = drive.current * table.at(data->qpos[dof]);
  }
}

std::vector<double> acceleration(const mjModel* model, mjData* data) {
  mj_forward(model, data);
  return {data->qacc, data->qacc + model->nv};
}

// Slopes of the accelerations by one of the coordinates or rates, central differences.
std::vector<double> slope(const mjModel* model, mjData* data, double* of) {
  constexpr double step = 1e-6;
  const double held = *of;
  *of = held + step;
  const std::vector<double> ahead = acceleration(model, data);
  *of = held - step;
  const std::vector<double> behind = acceleration(model, data);
  *of = held;
  std::vector<double> out;
  for (int i = 0; i < model->nv; ++i) out.push_back((ahead[i] - behind[i]) / (2.0 * step));
  return out;
}

// Newton's method on the accelerations at rest, each step solved by elimination.
void settle(const mjModel* model, mjData* data) {
  const int n = model->nv;
  for (int j = 0; j < n; ++j) data->qvel[j] = 0.0;
  for (int round = 0; round < 60; ++round) {
    std::vector<double> left = acceleration(model, data);
    std::vector<std::vector<double>> matrix(n, std::vector<double>(n));
    for (int j = 0; j < n; ++j) {
      const std::vector<double> column = slope(model, data, &data->qpos[j]);
      for (int i = 0; i < n; ++i) matrix[i][j] = column[i];
    }
    for (int k = 0; k < n; ++k)
      for (int i = k + 1; i < n; ++i) {
        const double factor = matrix[i][k] / matrix[k][k];
        for (int j = k; j < n; ++j) matrix[i][j] -= factor * matrix[k][j];
        left[i] -= factor * left[k];
      }
    double largest = 0.0;
    for (int i = n - 1; i >= 0; --i) {
      for (int j = i + 1; j < n; ++j) left[i] -= matrix[i][j] * left[j];
      left[i] /= matrix[i][i];
      largest = std::max(largest, std::abs(left[i]));
    }
    const double share = std::min(1.0, 0.1 / largest);
    for (int i = 0; i < n; ++i) data->qpos[i] -= share * left[i];
    if (largest < 1e-12) return;
  }
}

void print(const char* name, const double* values, int count, const char* end = ",\n") {
  std::printf("\"%s\": [", name);
  for (int i = 0; i < count; ++i) std::printf("%s%.15g", i == 0 ? "" : ", ", values[i]);
  std::printf("]%s", end);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  char error[1000] = "";
  mjModel* model = mj_loadXML(argv[1], nullptr, error, sizeof error);
  if (model == nullptr) {
    std::fprintf(stderr, "%s\n", error);
    return 1;
  }
  drive.tables = tables_of(argv[2]);
  const double current = std::stod(argv[3]);
  if (argc > 4) {
    for (const std::vector<double>& row : rows_of(argv[4])) {
      const int joint = mj_name2id(model, mjOBJ_JOINT, ("joint" + std::to_string(static_cast<int>(row[0]))).c_str());
      model->jnt_stiffness[joint] = row[1];
      model->qpos_spring[model->jnt_qposadr[joint]] = row[2];
    }
    model->opt.integrator = mjINT_RK4;
    model->opt.timestep = 1e-4;
  }
  mjcb_control = &apply;
  mjData* data = mj_makeData(model);
  std::printf("{");
  for (const double held : {0.0, current}) {
    if (held < 0.0) continue;  // pressed faces are no smooth function
    drive.current = held;
    settle(model, data);
    const bool driven = held != 0.0;
    print(driven ? "driven_angles" : "rest_angles", data->qpos, model->nv);
    std::vector<double> by_angle, by_rate;
    for (int j = 0; j < model->nv; ++j) {
      for (const double value : slope(model, data, &data->qpos[j])) by_angle.push_back(value);
      for (const double value : slope(model, data, &data->qvel[j])) by_rate.push_back(value);
    }
    print(driven ? "driven_by_angle" : "rest_by_angle", by_angle.data(), model->nv * model->nv);
    print(driven ? "driven_by_rate" : "rest_by_rate", by_rate.data(), model->nv * model->nv);
  }
  drive.current = 0.0;
  settle(model, data);
  drive.current = current;
  double fastest = 0.0;
  double when = 0.0;
  for (int i = 0; i * model->opt.timestep < 3.0; ++i) {
    mj_step(model, data);
    double rate = 0.0;
    for (int j = 0; j < model->nv; ++j) rate += data->qvel[j];
    if (rate > fastest) {
      fastest = rate;
      when = (i + 1) * model->opt.timestep;
    }
  }
  print("fastest", &fastest, 1);
  print("when", &when, 1);
  print("end_angles", data->qpos, model->nv, "}\n");
  mj_deleteData(data);
  mj_deleteModel(model);
}
