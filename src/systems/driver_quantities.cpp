#include "coilwright/systems/driver_quantities.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "coilwright/actuator/coil_bank.hpp"
#include "coilwright/drive/driver.hpp"
#include "coilwright/drive/settings.hpp"
#include "systems/tried.hpp"

namespace coilwright::systems {
namespace {

using simulation::DesignView;
using simulation::NoValue;
using simulation::ResultQuantity;
using simulation::SharedResult;
using Task = DriverTask;

drive::Driver driver_of_task(const Task& task) {
  if (task.kind == Task::Kind::cell)
    return driver_of(drive::CellSwitch{
        .emf = task.voltage, .resistance = task.resistance, .switch_resistance = task.switch_resistance});
  drive::HBridge bridge{.supply_voltage = task.voltage, .supply_resistance = task.resistance};
  const double of_usual = task.switch_resistance / (bridge.high_resistance + bridge.low_resistance);
  bridge.high_resistance *= of_usual;
  bridge.low_resistance *= of_usual;
  return driver_of(bridge);
}

drive::ReducedBank bank_at(const DesignView& design, const Eigen::VectorXd& temperatures) {
  const bool in_series = design.point.supply.wiring == actuator::Wiring::series;
  return reduce(coil_bank(design.design, design.assembly,
                          in_series ? drive::BankWiring::series : drive::BankWiring::parallel, temperatures));
}

struct DriverAnswer {
  double duty{};
  double most_current{};        // mean of a coil that is to be had, A
  drive::SteadyCurrent cold{};  // of the driver at that mean current
  double peak_over_limit{};
};

Try<DriverAnswer> answer_of(const Task& task, const DesignView& design) {
  const double wanted = std::abs(design.point.current);
  const bool only_gripping = design.point.cases == actuator::HeldCases::gripping;
  const simulation::Heat& heat = only_gripping ? design.performance.gripping.heat : design.performance.free.heat;
  const auto& nodes = heat.temperatures;
  const drive::Driver driver = driver_of_task(task);
  const auto at_full = [&](const drive::ReducedBank& bank) {
    return bank.shares.maxCoeff() *
           steady_current(bank.circuit, driver, {.frequency = task.frequency, .duty = 1.0}).mean;
  };
  const auto cannot_give = [&](double most, std::string_view when) {
    return NoValue{
        .reason = fmt::format("the driver cannot give the current: raise driver.voltage_V or lower current_A; "
                              "got {:.4g} A in a coil at most, {}, of {:.4g} A",
                              most, when, wanted),
        .infeasibility = wanted / most - 1.0};
  };
  const drive::ReducedBank cold_bank = bank_at(design, Eigen::VectorXd::Constant(design.assembly.coils, 20.0));
  if (nodes.size() == 0) {
    // What it cannot give does not heat the coils either.
    if (const double most = at_full(cold_bank); wanted > most) return cannot_give(most, "even at 20 degC");
    return NoValue{.reason = fmt::format("the driver cannot hold the current, at which the coils have no steady "
                                         "temperature: lower current_A or duty; got {:.4g} A",
                                         wanted),
                   .infeasibility = wanted * std::sqrt(design.point.duty) / heat.runaway_current};
  }
  const std::vector<int> places = actuator::coil_places(design.design.layout);
  Eigen::VectorXd warm(static_cast<Eigen::Index>(places.size()));
  for (Eigen::Index i = 0; i < warm.size(); ++i) warm[i] = nodes[places[static_cast<std::size_t>(i)]];
  const drive::ReducedBank warm_bank = bank_at(design, warm);
  DriverAnswer out{.most_current = at_full(warm_bank)};
  if (wanted == 0.0) return out;
  if (wanted > out.most_current) return cannot_give(out.most_current, "warm");
  const auto setting = [&](const drive::ReducedBank& bank) {
    return duty_for_mean(bank.circuit, driver, task.frequency, wanted / bank.shares.maxCoeff());
  };
  out.duty = setting(warm_bank).value.value_or(1.0);
  out.cold = setting(cold_bank).current;
  out.peak_over_limit = out.cold.peak / task.most_current;
  return out;
}

// Heat in the coils over that of their mean current.
double heat_ratio(const drive::SteadyCurrent& current) {
  return current.mean > 0.0 ? std::pow(current.rms / current.mean, 2) : 1.0;
}

}  // namespace

std::vector<ResultQuantity> driver_quantities(const std::function<Task(const simulation::Settings&)>& task) {
  using Value = std::optional<double>;
  const SharedResult<Try<DriverAnswer>> result([task](const DesignView& design) {
    return tried([&] { return answer_of(task(simulation::settings_of(design)), design); },
                 [](const std::exception&) { return 1.0; });
  });
  const auto row = [&result](std::string name, std::string meaning, double scale,
                             Value (*value)(const DriverAnswer&, const DesignView&)) {
    return ResultQuantity{.name = std::move(name),
                          .meaning = std::move(meaning),
                          .scale = scale,
                          .value = of_try(result, value),
                          .absence = "the driver cannot drive this current",
                          .why_absent = why_none(result)};
  };
  return {row("driver_duty", "share of a period that is switched on for the current as a mean, coils warm", 1.0,
              [](const DriverAnswer& driven, const DesignView&) -> Value { return driven.duty; }),
          row("driver_most_current_A", "mean current of a coil with the switch closed for good, coils warm", 1.0,
              [](const DriverAnswer& driven, const DesignView&) -> Value { return driven.most_current; }),
          row("driver_peak_A", "largest current of the driver, coils at 20 degC", 1.0,
              [](const DriverAnswer& driven, const DesignView&) -> Value { return driven.cold.peak; }),
          simulation::of_every_use(
              row("driver_peak_over_limit", "that over the most that bridge or cell bears", 1.0,
                  [](const DriverAnswer& driven, const DesignView&) -> Value { return driven.peak_over_limit; })),
          row("driver_ripple_heat_pct", "heat of the coils beyond that of their mean current, coils at 20 degC", 5.0,
              [](const DriverAnswer& driven, const DesignView&) -> Value {
                return 100.0 * (heat_ratio(driven.cold) - 1.0);
              }),
          simulation::of_every_use(row("driver_thermal_load", "thermal_load of the current with its ripple", 1.0,
                                       [](const DriverAnswer& driven, const DesignView& design) -> Value {
                                         static const ResultQuantity load =
                                             simulation::standard_quantities().at("thermal_load");
                                         const Value mean = load.value(design);
                                         return mean ? Value(*mean * std::sqrt(heat_ratio(driven.cold))) : std::nullopt;
                                       }))};
}

}  // namespace coilwright::systems
