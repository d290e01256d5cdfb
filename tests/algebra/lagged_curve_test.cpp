#include "coilwright/algebra/lagged_curve.hpp"

#include <gtest/gtest.h>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

namespace coilwright::algebra {
namespace {

namespace odeint = boost::numeric::odeint;

// A lag from far below the time between rows to far above it, by an integrator.
TEST(LaggedCurve, IsWhatAnIntegratorFinds) {
  std::vector<double> times, values;
  for (int k = 0; k <= 20; ++k) {
    times.push_back(0.002 * k + (k % 3 == 1 ? 1e-4 : 0.0));
    values.push_back(std::sin(50.0 * times.back()));
  }
  const SmoothCurve curve(times, values, 1);
  for (const double lag : {5e-5, 3e-4, 2e-3, 2e-2}) {
    const LaggedCurve lagged(curve, lag, std::vector{0.3});
    std::vector<double> x{0.3};
    double time = 0.0;
    for (const double until : {0.0005, 0.002, 0.0107, 0.04}) {
      const auto slope = [&](const std::vector<double>& at, std::vector<double>& out, double t) {
        double u = 0.0;
        curve.at(t, std::span(&u, 1));
        out[0] = (u - at[0]) / lag;
      };
      odeint::integrate_adaptive(odeint::make_controlled<odeint::runge_kutta_dopri5<std::vector<double>>>(1e-12, 1e-12),
                                 slope, x, time, until, 1e-6);
      time = until;
      double found = 0.0;
      lagged.at(until, std::span(&found, 1));
      EXPECT_NEAR(found, x[0], 1e-10) << lag << " at " << until;
    }
  }
}

}  // namespace
}  // namespace coilwright::algebra
