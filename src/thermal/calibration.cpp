#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

#include "check.hpp"
#include "coilwright/thermal/chain.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::thermal {
namespace {

constexpr double least_transfer = 0.01;  // W/(m2 K), far below still air
constexpr double most_transfer = 10e3;   // W/(m2 K), boiling water

double allowed_current(HeatChain chain, double heat_transfer) {
  chain.heat_transfer = heat_transfer;
  return continuous_current(build_network(chain), LimitedParts::coils).current;
}

}  // namespace

double calibrate_heat_transfer(const HeatChain& chain, double continuous_current) {
  require_positive({"continuous_current"}, continuous_current);
  // More transfer always allows more current; over logarithms both ends of the range are alike.
  const auto surplus = [&](double logarithm) {
    return allowed_current(chain, std::exp(logarithm)) / continuous_current - 1.0;
  };
  const double low = std::log(least_transfer);
  const double high = std::log(most_transfer);
  const double at_low = surplus(low);
  const double at_high = surplus(high);
  if (!(at_low < 0.0 && at_high > 0.0)) {
    reject({"continuous_current"},
           fmt::format("between {:.4g} A ({} W/(m2 K)) and {:.4g} A ({} W/(m2 K))", continuous_current * (1.0 + at_low),
                       least_transfer, continuous_current * (1.0 + at_high), most_transfer),
           continuous_current);
  }
  std::uintmax_t steps = 100;
  const auto bracket = boost::math::tools::toms748_solve(surplus, low, high, at_low, at_high,
                                                         boost::math::tools::eps_tolerance<double>(40), steps);
  return std::exp(0.5 * (bracket.first + bracket.second));
}

}  // namespace coilwright::thermal
