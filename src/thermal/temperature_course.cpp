#include "coilwright/thermal/temperature_course.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "check.hpp"
#include "hottest_spot.hpp"

namespace coilwright::thermal {
namespace {

namespace odeint = boost::numeric::odeint;

// Of a step, K and relative: a hundredth of a kelvin after a thousand steps. Less would look into how a current limit
// that beats with the pulses makes a mean current tremble.
constexpr double absolute_error = 1e-5, relative_error = 1e-7;
constexpr double first_step = 1e-3;  // s

using Temperatures = std::vector<double>;  // degC, a value a node

NodeVector vector_of(const Temperatures& now) {
  return Eigen::Map<const Eigen::VectorXd>(now.data(), static_cast<Eigen::Index>(now.size()));
}

// Where `of` (time) first is zero, between a time at which it is below and one at which it is not, s.
template <class Function>
double crossing(const Function& of, double before, double after) {
  if (of(before) >= 0.0) return before;
  std::uintmax_t most = 100;
  const auto ends =
      boost::math::tools::toms748_solve(of, before, after, boost::math::tools::eps_tolerance<double>(40), most);
  return ends.second;
}

}  // namespace

TemperatureCourse temperature_course(const Network& network, const HeatAt& heat, const CourseTiming& timing) {
  require_positive({"duration"}, timing.duration);
  require_positive({"interval"}, timing.interval);
  require(timing.interval <= timing.duration, {"interval"}, "at most the duration", timing.interval);
  const auto slopes = [&](const Temperatures& now, Temperatures& out, double /*time*/) {
    const NodeVector mean = vector_of(now);
    const NodeVector gained = heat(mean) - network.conductance() * (mean.array() - network.ambient()).matrix();
    for (std::size_t i = 0; i < now.size(); ++i)
      out[i] = gained[static_cast<Eigen::Index>(i)] / network.nodes()[i].heat_capacity;
  };
  Temperatures now(network.nodes().size(), network.ambient());
  TemperatureCourse out{.times = {0.0}, .temperatures = {vector_of(now)}};
  if (const HottestSpot spot = hottest_spot(network, vector_of(now)); spot.excess >= 0.0)
    out.limit = TimeToLimit{.time = 0.0, .node = spot.node};
  auto stepper = odeint::make_dense_output(absolute_error, relative_error, odeint::runge_kutta_dopri5<Temperatures>());
  stepper.initialize(now, 0.0, std::min(first_step, timing.duration));
  const auto at = [&](double time) {
    stepper.calc_state(time, now);
    return vector_of(now);
  };
  const auto above_limit = [&](double time) { return hottest_spot(network, at(time)).excess; };
  const auto above_highest = [&](double time) { return at(time).maxCoeff() - timing.highest; };
  const auto time_of = [&](double number) { return std::min(number * timing.interval, timing.duration); };
  double next = 1.0;  // number of the next look
  while (out.times.back() < timing.duration && !out.highest_reached) {
    const auto [begin, stepped] = stepper.do_step(slopes);
    const double end = std::min(stepped, timing.duration);
    if (!out.limit && above_limit(end) >= 0.0) {
      const double time = crossing(above_limit, begin, end);
      out.limit = TimeToLimit{.time = time, .node = hottest_spot(network, at(time)).node};
    }
    if (above_highest(end) >= 0.0) out.highest_reached = crossing(above_highest, begin, end);
    for (; out.times.back() < timing.duration && time_of(next) <= out.highest_reached.value_or(end); next += 1.0) {
      out.times.push_back(time_of(next));
      out.temperatures.push_back(at(out.times.back()));
    }
  }
  return out;
}

}  // namespace coilwright::thermal
