#include "coilwright/drive/coil_bank.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coilwright::drive {
namespace {

// Roundings of a matrix that is symmetric by its making.
constexpr double symmetric = 1e-12;

void check(const CoilBank& bank) {
  const Eigen::Index coils = bank.resistances.size();
  if (coils < 1) throw std::invalid_argument(fmt::format("resistances: at least one coil is needed; got {}", coils));
  for (Eigen::Index i = 0; i < coils; ++i)
    if (!(std::isfinite(bank.resistances[i]) && bank.resistances[i] > 0.0))
      throw std::invalid_argument(
          fmt::format("resistances: must be finite and > 0; got {} of coil {}", bank.resistances[i], i));
  const Eigen::MatrixXd& L = bank.inductances;
  if (L.rows() != coils || L.cols() != coils)
    throw std::invalid_argument(
        fmt::format("inductances: must be {} by {}, a row a coil; got {} by {}", coils, coils, L.rows(), L.cols()));
  if (!L.allFinite() || (L - L.transpose()).cwiseAbs().maxCoeff() > symmetric * L.cwiseAbs().maxCoeff() ||
      Eigen::LLT<Eigen::MatrixXd>(L).info() != Eigen::Success)
    throw std::invalid_argument(
        fmt::format("inductances: must be symmetric and positive definite; got a first entry of {}", L(0, 0)));
}

}  // namespace

ReducedBank reduce(const CoilBank& bank) {
  check(bank);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(bank.resistances.size());
  if (bank.wiring == BankWiring::series)
    return {.circuit = {.resistance = bank.resistances.sum(), .inductance = bank.inductances.sum()}, .shares = ones};
  const Eigen::VectorXd conductances = bank.resistances.cwiseInverse();
  const double resistance = 1.0 / conductances.sum();
  const Eigen::VectorXd shares = resistance * conductances;
  const double slowly = shares.dot(bank.inductances * shares);
  const double at_once = 1.0 / ones.dot(Eigen::LLT<Eigen::MatrixXd>(bank.inductances).solve(ones));
  return {.circuit = {.resistance = resistance, .inductance = slowly},
          .shares = shares,
          .inductance_spread = std::max(0.0, 1.0 - at_once / slowly)};
}

}  // namespace coilwright::drive
