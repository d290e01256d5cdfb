#include "measurement/fit/input_errors.hpp"

#include <vector>

#include "measurement/fit/parallel.hpp"
#include "measurement/replay/input_whitener.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::fit {

void weigh_input_errors(std::span<replay::PreparedRun> runs, const Hypothesis& hypothesis,
                        const Eigen::VectorXd& values, const Fit* fitted) {
  in_parallel(runs.size(), [&](std::size_t r) {
    if (runs[r].run->input_uncertainty.sigma.empty()) return;
    const actuator::Model model(replay::on_changed_rig(hypothesis.spec_at(values), runs[r].run->rig));
    static const std::vector<std::vector<double>> priors;
    replay::weigh_input_errors(runs[r], model, fitted != nullptr ? fitted->runs[r].local_numbers : priors);
  });
}

}  // namespace coilwright::measurement::fit
