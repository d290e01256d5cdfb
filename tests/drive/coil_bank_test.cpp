#include "coilwright/drive/coil_bank.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <complex>

#include "error_text.hpp"

namespace coilwright::drive {
namespace {

CoilBank three_unlike(BankWiring wiring) {
  CoilBank bank{
      .resistances = Eigen::Vector3d(3.8, 4.3, 2.9), .inductances = Eigen::MatrixXd::Zero(3, 3), .wiring = wiring};
  bank.inductances << 1.15e-3, 21e-6, -3e-6, 21e-6, 0.97e-3, 17e-6, -3e-6, 17e-6, 1.4e-3;
  return bank;
}

// Impedance of the bank from all of its equations at once, (R + j w L) i = u 1.
std::complex<double> impedance(const CoilBank& bank, double omega) {
  const Eigen::Index n = bank.resistances.size();
  Eigen::MatrixXcd matrix = std::complex<double>(0.0, omega) * bank.inductances.cast<std::complex<double>>();
  matrix.diagonal() += bank.resistances.cast<std::complex<double>>();
  if (bank.wiring == BankWiring::series) return matrix.sum();
  const Eigen::VectorXcd currents = matrix.partialPivLu().solve(Eigen::VectorXcd::Ones(n));
  return 1.0 / currents.sum();
}

TEST(CoilBank, SeenFromTheDriverIsItsImpedanceAtLowAndHighFrequency) {
  for (const BankWiring wiring : {BankWiring::series, BankWiring::parallel}) {
    const CoilBank bank = three_unlike(wiring);
    const ReducedBank reduced = reduce(bank);
    // (w L / R)^2 is 1e-9 at 0.1 rad/s.
    EXPECT_NEAR(impedance(bank, 0.1).real() / reduced.circuit.resistance, 1.0, 1e-8);
    EXPECT_NEAR(impedance(bank, 0.1).imag() / 0.1 / reduced.circuit.inductance, 1.0, 1e-8);
    // (R / w L)^2 is 1e-9 at 1e8 rad/s.
    EXPECT_NEAR(impedance(bank, 1e8).imag() / 1e8 / (reduced.circuit.inductance * (1.0 - reduced.inductance_spread)),
                1.0, 1e-8);
    EXPECT_GE(reduced.inductance_spread, 0.0);
  }
  EXPECT_GT(reduce(three_unlike(BankWiring::parallel)).inductance_spread, 0.01);
}

TEST(CoilBank, OfLikeCoilsHasNoSpread) {
  CoilBank bank{.resistances = Eigen::Vector2d::Constant(3.7), .inductances = Eigen::MatrixXd::Zero(2, 2)};
  bank.inductances << 1.2e-3, 0.1e-3, 0.1e-3, 1.2e-3;
  const ReducedBank parallel = reduce(bank);
  EXPECT_DOUBLE_EQ(parallel.circuit.resistance, 1.85);
  EXPECT_DOUBLE_EQ(parallel.circuit.inductance, 0.65e-3);  // (L + M) / 2
  EXPECT_NEAR(parallel.inductance_spread, 0.0, 1e-15);     // roundings
  EXPECT_DOUBLE_EQ(parallel.shares[1], 0.5);
  bank.wiring = BankWiring::series;
  const ReducedBank series = reduce(bank);
  EXPECT_DOUBLE_EQ(series.circuit.resistance, 7.4);
  EXPECT_DOUBLE_EQ(series.circuit.inductance, 2.6e-3);  // 2 (L + M)
  EXPECT_EQ(series.shares, Eigen::Vector2d::Ones());
}

TEST(CoilBank, HeatsInParallelAsOneResistance) {
  // The heat of the shares is that of the reduced resistance: the book balances whatever the coils.
  const CoilBank bank = three_unlike(BankWiring::parallel);
  const ReducedBank reduced = reduce(bank);
  EXPECT_NEAR(reduced.shares.cwiseAbs2().dot(bank.resistances) / reduced.circuit.resistance, 1.0, 1e-14);
  EXPECT_NEAR(reduced.shares.sum(), 1.0, 1e-14);  // roundings
}

TEST(CoilBank, RejectsWhatIsNone) {
  CoilBank bank = three_unlike(BankWiring::series);
  bank.resistances[1] = -0.3;
  EXPECT_EQ(error_text([&] { (void)reduce(bank); }), "resistances: must be finite and > 0; got -0.3 of coil 1");
  bank = three_unlike(BankWiring::series);
  bank.inductances(0, 1) *= 1.1;
  EXPECT_EQ(error_text([&] { (void)reduce(bank); }),
            "inductances: must be symmetric and positive definite; got a first entry of 0.00115");
  bank.inductances = Eigen::Matrix2d::Identity();
  EXPECT_EQ(error_text([&] { (void)reduce(bank); }), "inductances: must be 3 by 3, a row a coil; got 2 by 2");
  EXPECT_EQ(error_text([] { (void)reduce({}); }), "resistances: at least one coil is needed; got 0");
}

}  // namespace
}  // namespace coilwright::drive
