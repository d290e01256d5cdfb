#include "coilwright/magnetics/irreversible_loss.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "coilwright/magnetics/constants.hpp"
#include "coilwright/magnetics/magnet_grade.hpp"

namespace coilwright::magnetics {
namespace {

using testing::ThrowsMessage;

constexpr CylinderSize flat_disc{.radius = 10e-3, .length = 6e-3};

DemagnetisationCurve n52_at(double temperature) {
  const MagnetGrade& grade = *find_magnet_grade("N52");
  return {.magnetisation = grade.remanence * share_at(temperature, grade.remanence_coefficient) / vacuum_permeability,
          .coercivity = grade.coercivity * share_at(temperature, grade.coercivity_coefficient),
          .susceptibility = grade.recoil_permeability - 1.0};
}

FaceValues everywhere(double field) {
  FaceValues out{};
  out.fill(field);
  return out;
}

TEST(DemagnetisationCurve, HasItsKneeWhereSquarenessPutsIt) {
  const DemagnetisationCurve curve{.magnetisation = 1.1e6, .coercivity = 900e3, .susceptibility = 0.05};
  EXPECT_EQ(curve.at(0.0), 1.1e6);
  EXPECT_NEAR(curve.at(-400e3), 1.1e6 - 0.05 * 400e3, 1e-6);
  EXPECT_NEAR(curve.at(-0.95 * 900e3), 0.95 * 1.1e6, 1e-6);
  EXPECT_NEAR(curve.at(-900e3), 0.0, 1e-6);
  EXPECT_EQ(curve.at(-2000e3), -1.1e6);
}

// Makers' Hk has 0.9 of the remanence.
TEST(DemagnetisationCurve, PassesWhereMakersStateItsSquareness) {
  for (const double squareness : {0.8, 0.9, 0.95, 0.99}) {
    const DemagnetisationCurve curve{.magnetisation = 1.1e6, .coercivity = 900e3, .squareness = squareness};
    EXPECT_NEAR(curve.at(-squareness * 900e3), squareness * 1.1e6, 1e-6);
    EXPECT_NEAR(curve.at(-(1.0 - 0.9 * (1.0 - squareness) / squareness) * 900e3), 0.9 * 1.1e6, 1e-6);
    EXPECT_NEAR(curve.at(-(1.0 - curve.knee_margin()) * 900e3), 1.1e6, 1e-6);
    EXPECT_NEAR(curve.at(-(1.0 - 0.9 * curve.knee_margin()) * 900e3), 0.9 * 1.1e6, 1e-6);
  }
}

// The charges of the end faces of one cell, integrated over the circle: another route than sheets of current.
double field_of_disc(double radius, double charge_height, double at_radius, double at_height) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double z = at_height - charge_height;
  const auto over_circle = [&](double r) {
    const auto over_angle = [&](double angle) {
      const double square = r * r + at_radius * at_radius - 2.0 * r * at_radius * std::cos(angle) + z * z;
      return z / (square * std::sqrt(square));
    };
    return r * 2.0 * Rule::integrate(over_angle, 0.0, std::numbers::pi, 12, 1e-9);
  };
  const double near = std::clamp(at_radius, 0.0, radius);
  return (Rule::integrate(over_circle, 0.0, near, 12, 1e-8) + Rule::integrate(over_circle, near, radius, 12, 1e-8)) /
         (4.0 * std::numbers::pi);
}

// 6 rings by 8 discs by charges, all cells relaxed at once: shares neither the kernels, nor the mesh, nor the
// iteration.
double loss_by_charges(const CylinderSize& size, const DemagnetisationCurve& curve) {
  constexpr int rings = 6;
  constexpr int slices = 8;
  constexpr int count = rings * slices;
  Eigen::MatrixXd factors(count, count);
  const auto middle_radius = [&](int i) { return size.radius * (i % rings + 0.5) / rings; };
  const auto middle_height = [&](int i) { return size.length * (i / rings + 0.5) / slices; };
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k) {
      const double bottom = size.length * (k / rings) / slices;
      const double top = bottom + size.length / slices;
      const auto of_disc = [&](double radius) {
        if (radius == 0.0) return 0.0;
        return field_of_disc(radius, top, middle_radius(i), middle_height(i)) -
               field_of_disc(radius, bottom, middle_radius(i), middle_height(i));
      };
      factors(i, k) = -(of_disc(size.radius * (k % rings + 1) / rings) - of_disc(size.radius * (k % rings) / rings));
    }
  // The steepest curve here has a slope of 62 (105 degC), and explicit steps are stable below 2 / 63.
  constexpr double step = 0.02;
  Eigen::VectorXd m = Eigen::VectorXd::Constant(count, curve.magnetisation);
  double change = curve.magnetisation;
  for (int steps = 0; change > 1e-9 * curve.magnetisation && steps < 100000; ++steps) {
    const Eigen::VectorXd field = -factors * m;
    Eigen::VectorXd way(count);
    for (int i = 0; i < count; ++i) way[i] = step * (curve.at(field[i]) - m[i]);
    m += way;
    change = way.lpNorm<Eigen::Infinity>();
  }
  const Eigen::VectorXd field = -factors * m;
  double kept = 0.0;
  double volume = 0.0;
  for (int i = 0; i < count; ++i) {
    const double share = 2 * (i % rings) + 1;
    kept += share * (m[i] - curve.susceptibility * field[i]);
    volume += share;
  }
  return 1.0 - kept / (volume * curve.magnetisation);
}

TEST(IrreversibleLoss, AgreesWithCharges) {
  for (const double temperature : {50.0, 80.0, 105.0})
    EXPECT_NEAR(irreversible_loss(flat_disc, n52_at(temperature), {}), loss_by_charges(flat_disc, n52_at(temperature)),
                0.003)
        << temperature;
}

// docs/theory/magnetics.md, "Irreversible loss": the loss of the prototype's disc by squareness, whole tenths of a per
// cent. Another mesh agrees to 0.3 %, as above.
TEST(IrreversibleLoss, IsMoreWithARounderKnee) {
  DemagnetisationCurve curve = n52_at(60.0);
  for (const auto& [squareness, loss] : {std::pair{0.9, 0.147}, {0.95, 0.118}, {0.99, 0.097}}) {
    curve.squareness = squareness;
    EXPECT_NEAR(irreversible_loss(flat_disc, curve, {}), loss, 0.0005) << squareness;
  }
  curve.squareness = 0.9;
  EXPECT_NEAR(irreversible_loss(flat_disc, curve, {}), loss_by_charges(flat_disc, curve), 0.003);
}

// An audit of the physics, with a square curve (0.99 in place of 0.95) and cells of its own: the prototype's disc loses
// 9 % at 60 degC, 22 % at 80 and 44 % at 105. A rounder knee costs 1 to 2.5 % of the moment more.
TEST(IrreversibleLoss, LiesAboveThatOfASquareCurve) {
  for (const auto& [temperature, square] : {std::pair{60.0, 0.09}, {80.0, 0.22}, {105.0, 0.44}}) {
    EXPECT_GT(irreversible_loss(flat_disc, n52_at(temperature), {}), square + 0.005) << temperature;
    EXPECT_LT(irreversible_loss(flat_disc, n52_at(temperature), {}), square + 0.03) << temperature;
  }
}

// A long rod's middle has no field of its own: in an outside field beyond the coercivity it goes over as a whole, and
// short of the knee it keeps all. At -HcJ the middle keeps chi HcJ on its way back to no field.
TEST(IrreversibleLoss, IsThatOfTheCurveInALongRod) {
  const DemagnetisationCurve curve{.magnetisation = 1.0e6, .coercivity = 900e3, .susceptibility = 0.05};
  const CylinderSize rod{.radius = 1e-3, .length = 400e-3};
  EXPECT_NEAR(irreversible_loss(rod, curve, everywhere(-0.93 * 900e3)), 0.0, 1e-3);
  EXPECT_NEAR(irreversible_loss(rod, curve, everywhere(-900e3)), 1.0 - 0.05 * 0.9, 3e-3);
  EXPECT_NEAR(irreversible_loss(rod, curve, everywhere(-3000e3)), 2.0 - 0.05 * 3.0, 3e-3);
}

TEST(IrreversibleLoss, GrowsWithHeatAndWithThinness) {
  double before = irreversible_loss(flat_disc, n52_at(20.0), {});
  EXPECT_LT(before, 1e-3);
  for (double temperature = 30.0; temperature < 140.0; temperature += 10.0) {
    const double next = irreversible_loss(flat_disc, n52_at(temperature), {});
    EXPECT_GT(next, before) << temperature;
    before = next;
  }
  EXPECT_EQ(irreversible_loss(flat_disc, n52_at(160.0), {}), 1.0);
  EXPECT_EQ(irreversible_loss(flat_disc, n52_at(900.0), {}), 1.0);  // no remanence either
  EXPECT_GT(irreversible_loss({.radius = 10e-3, .length = 1e-3}, n52_at(20.0), {}), 0.05);
  EXPECT_NEAR(irreversible_loss({.radius = 10e-3, .length = 14e-3}, n52_at(20.0), {}), 0.0, 1e-12);
}

TEST(IrreversibleLoss, DoesNotKnowUpFromDown) {
  FaceValues one{};
  FaceValues other{};
  for (std::size_t i = 0; i < face_points / 2; ++i) {
    one[i] = other[i + face_points / 2] = -90e3;
    other[i] = one[i + face_points / 2] = -20e3;
  }
  EXPECT_NEAR(irreversible_loss(flat_disc, n52_at(50.0), one), irreversible_loss(flat_disc, n52_at(50.0), other), 1e-8);
  EXPECT_GT(irreversible_loss(flat_disc, n52_at(50.0), one), irreversible_loss(flat_disc, n52_at(50.0), {}));
}

TEST(IrreversibleLoss, SaysWhichNumberBreaksWhichRule) {
  using Error = std::invalid_argument;
  EXPECT_THAT([] { (void)irreversible_loss({.radius = 0.0, .length = 1.0}, n52_at(20.0), {}); },
              ThrowsMessage<Error>("cylinder radius must be finite and > 0; got 0"));
  EXPECT_THAT([] { (void)irreversible_loss(flat_disc, {.magnetisation = -1.0, .coercivity = 1.0}, {}); },
              ThrowsMessage<Error>("magnetisation must be finite and >= 0; got -1"));
  EXPECT_THAT(
      [] { (void)irreversible_loss(flat_disc, {.magnetisation = 1.0, .coercivity = 1.0, .susceptibility = -0.1}, {}); },
      ThrowsMessage<Error>("susceptibility must be >= 0; got -0.1"));
  EXPECT_THAT(
      [] { (void)irreversible_loss(flat_disc, {.magnetisation = 1.0, .coercivity = 1.0, .squareness = 1.0}, {}); },
      ThrowsMessage<Error>("squareness must be > 0.5 and < 1; got 1"));
}

}  // namespace
}  // namespace coilwright::magnetics
