#include "coilwright/systems/warm_up.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "coilwright/actuator/coil_bank.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/thermal/temperature_course.hpp"
#include "systems/driven_coils.hpp"
#include "systems/require_timing.hpp"

namespace coilwright::systems {
namespace {

using thermal::NodeKind;
using thermal::NodeVector;

class Warming {
 public:
  Warming(const actuator::Design& design, const actuator::Assembly& assembly, const DriveQuestion& question,
          const DrivenActuator& answer)
      : network_(heat_network(design, assembly)),
        places_(actuator::coil_places(design.layout)),
        one_(coil_bank(design, assembly, question.wiring, answer.coil_temperatures)),
        actuators_(question.actuators),
        driver_(answer.phases),
        pulses_{.frequency = question.frequency, .duty = answer.duty} {}

  [[nodiscard]] const thermal::Network& network() const { return network_; }

  [[nodiscard]] NodeVector heat(const NodeVector& temperatures) const {
    return heat_of(temperatures, driven_at(temperatures));
  }

  [[nodiscard]] WarmUpSample sample(double time, const NodeVector& temperatures) const {
    const Driven driven = driven_at(temperatures);
    const NodeVector hot_spots = network_.hot_spots(temperatures);
    WarmUpSample out{.time = time,
                     .coil_temperatures = Eigen::VectorXd(static_cast<Eigen::Index>(places_.size())),
                     .coil_hot_spot = -std::numeric_limits<double>::infinity(),
                     .magnet_temperature = network_.ambient(),
                     .resistance = driven.bank.circuit.resistance,
                     .mean = driven.current.mean * driven.bank.shares.maxCoeff(),
                     .rms = driven.current.rms * driven.bank.shares.maxCoeff(),
                     .supply_mean = driven.current.supply_mean,
                     .heat = heat_of(temperatures, driven).sum()};
    for (std::size_t c = 0; c < places_.size(); ++c) {
      out.coil_temperatures[static_cast<Eigen::Index>(c)] = temperatures[places_[c]];
      out.coil_hot_spot = std::max(out.coil_hot_spot, hot_spots[places_[c]]);
    }
    for (std::size_t i = 0; i < network_.nodes().size(); ++i)
      if (network_.nodes()[i].kind == NodeKind::magnet)
        out.magnet_temperature = std::max(out.magnet_temperature, hot_spots[static_cast<Eigen::Index>(i)]);
    return out;
  }

 private:
  struct Driven {
    drive::ReducedBank bank;
    drive::SteadyCurrent current;
  };

  [[nodiscard]] double resistance_of(std::size_t coil, const NodeVector& temperatures) const {
    const int place = places_[coil];
    return network_.nodes()[static_cast<std::size_t>(place)].resistance *
           (1.0 + network_.temperature_coefficient() * (temperatures[place] - 20.0));
  }

  [[nodiscard]] Driven driven_at(const NodeVector& temperatures) const {
    const auto coils = static_cast<Eigen::Index>(places_.size());
    drive::CoilBank one = one_;
    for (Eigen::Index c = 0; c < coils; ++c)
      one.resistances[c] = resistance_of(static_cast<std::size_t>(c), temperatures);
    const drive::CoilBank all = of_like_actuators(one, actuators_);
    Driven out{.bank = reduce(all), .current = {}};
    out.current = steady_current(out.bank.circuit, driver_, pulses_);
    return out;
  }

  [[nodiscard]] NodeVector heat_of(const NodeVector& temperatures, const Driven& driven) const {
    NodeVector out = NodeVector::Zero(network_.size());
    for (std::size_t c = 0; c < places_.size(); ++c)
      out[places_[c]] = resistance_of(c, temperatures) *
                        std::pow(driven.bank.shares[static_cast<Eigen::Index>(c)] * driven.current.rms, 2);
    return out;
  }

  thermal::Network network_;
  std::vector<int> places_;
  drive::CoilBank one_;
  int actuators_;
  drive::Driver driver_;
  drive::Pulses pulses_;
};

PassedLimit passed(const thermal::Network& network, double time, std::size_t node) {
  const auto& nodes = network.nodes();
  const auto before = std::count_if(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(node),
                                    [&](const thermal::Node& each) { return each.kind == nodes[node].kind; });
  return {.time = time,
          .kind = nodes[node].kind,
          .number = static_cast<int>(before) + 1,
          .limit = nodes[node].temperature_limit};
}

}  // namespace

WarmUp warm_up(const actuator::Design& design, const actuator::Assembly& assembly, const DriveQuestion& question,
               const DrivenActuator& answer, const MotionTiming& timing) {
  require_timing(timing);
  require_samples(timing, most_warm_up_samples);
  const Warming warming(design, assembly, question, answer);
  const thermal::TemperatureCourse course =
      temperature_course(warming.network(), [&](const NodeVector& temperatures) { return warming.heat(temperatures); },
                         {.duration = timing.duration, .interval = timing.interval, .highest = copper_melts});
  WarmUp out{.melting_time = course.highest_reached};
  for (std::size_t i = 0; i < course.times.size(); ++i)
    out.samples.push_back(warming.sample(course.times[i], course.temperatures[i]));
  if (course.limit) out.limit = passed(warming.network(), course.limit->time, course.limit->node);
  return out;
}

}  // namespace coilwright::systems
