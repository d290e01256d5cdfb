#include "systems/second_engine/crawling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <vector>

#include "systems/second_engine/scene.hpp"
#include "systems/second_engine/stepper.hpp"

namespace second_engine {

namespace {

class Crawling {
 public:
  Crawling(mjModel* model, mjData* data, const Tables& tables)
      : model_(model),
        data_(data),
        stepper_(model, data, {number(model, "friction_forwards"), number(model, "friction_backwards")}),
        joints_(driven_joints(model, tables)),
        forwards_(model->jnt_dofadr[id_of(model, mjOBJ_JOINT, "forwards")]) {
    act_by([this](const mjModel*, mjData*) { apply(); });
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

void crawl(mjModel* model, mjData* data, const Tables& tables) {
  Crawling(model, data, tables).run();
}

}  // namespace second_engine
