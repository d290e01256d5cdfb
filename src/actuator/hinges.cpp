#include "coilwright/actuator/hinges.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "actuator/chain_of.hpp"
#include "coilwright/actuator/design/segments.hpp"
#include "coilwright/mechanics/silicone_hinge.hpp"

namespace coilwright::actuator {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

// The prototype's joint as it was measured: Tables I and II of the source paper, and the frequency of its finger with
// segments as bodies.
constexpr double prototype_width = 22e-3;
constexpr double prototype_bottom_layer = 2.5e-3;
constexpr double prototype_stiffness = 12.5e-3;
constexpr double prototype_first_mode = 5.0;

struct CrossSection {
  double width{};
  double bottom_layer{};
};

// By the design's law and material, before calibration.
double derived_stiffness(const Design& design, const CrossSection& section) {
  const BodyDesign& body = design.body;
  const double modulus = hinge_silicone(design).modulus();
  const mechanics::Rubber rubber{.young_modulus = modulus,
                                 .poisson_ratio = body.poisson_ratio,
                                 .modulus_above = design.bottom_silicone ? body.modulus() / modulus : 1.0};
  if (design.choices.hinge == HingeLaw::beam)
    return mechanics::hinge_stiffness(
        {.width = section.width, .height = section.bottom_layer, .length = body.hinge_length}, rubber.young_modulus);
  const double slot = design.choices.hinge == HingeLaw::slot ? body.slot_width : 0.0;
  return mechanics::ligament_stiffness({.width = section.width, .height = section.bottom_layer, .slot_width = slot},
                                       rubber);
}

// Damping over stiffness of the silicone, s.
double silicone_loss_time(const Design& design, double first_mode) {
  return design.choices.damping == DampingLaw::loss_factor ? design.body.loss_factor / (two_pi * first_mode)
                                                           : design.body.loss_time;
}

double silicone_damping(const Design& design, const CrossSection& section, double first_mode) {
  return design.calibration.joint_damping * derived_stiffness(design, section) * silicone_loss_time(design, first_mode);
}

// The same of a joint of known stiffness, whatever silicone the design has had since that was found.
double silicone_damping(const Design& design, double stiffness, double first_mode) {
  return design.calibration.joint_damping / design.calibration.joint_stiffness * stiffness *
         silicone_loss_time(design, first_mode);
}

// What a linear loss of whatever cause scales by between fingers of one shape: a viscosity times a volume.
double volume_scale(double width) {
  const double ratio = width / prototype_width;
  return ratio * ratio * ratio;
}

double constant_damping(const Design& design, double width) {
  return design.calibration.constant_damping * design.body.constant_damping * volume_scale(width);
}

CrossSection section_of(const HingeReference& reference) {
  return {.width = reference.width, .bottom_layer = reference.bottom_layer};
}

void check_measured(double value, const char* name) {
  if (!std::isfinite(value) || value <= 0.0)
    throw std::invalid_argument(fmt::format("measured {} must be finite and > 0; got {}", name, value));
}

// The silicone's part is known by its law; what was measured beyond it is the constant part. Where that leaves no
// constant part (none is wanted, or b is below the silicone's own), the silicone has all of b.
void calibrate_damping(Design& design, double measured, const Dimensions& size, double first_mode) {
  Calibration& factors = design.calibration;
  factors.joint_damping = factors.joint_stiffness;
  factors.constant_damping = 0.0;
  const double silicone = hinge_damping(design, size, first_mode);
  if (design.body.constant_damping > 0.0 && measured >= silicone) {
    factors.constant_damping = (measured - silicone) / (design.body.constant_damping * volume_scale(size.width));
    return;
  }
  if (silicone <= 0.0)
    throw std::invalid_argument("measured joint damping: the body has neither a loss nor a constant damping to scale");
  factors.joint_damping *= measured / silicone;
}

}  // namespace

double hinge_stiffness(const Design& design, const Dimensions& dimensions) {
  return design.calibration.joint_stiffness *
         derived_stiffness(design, {.width = dimensions.width, .bottom_layer = design.body.bottom_layer});
}

double hinge_damping(const Design& design, const Dimensions& dimensions, double first_mode) {
  const CrossSection section{.width = dimensions.width, .bottom_layer = design.body.bottom_layer};
  return silicone_damping(design, section, first_mode) + constant_damping(design, section.width);
}

double first_mode_frequency(const mechanics::PlanarChain& chain, double stiffness) {
  const mechanics::JointVector straight = mechanics::JointVector::Zero(chain.joints());
  mechanics::JointMatrix restoring = chain.under_gravity(chain.gravity(), 0.0).gravity_stiffness(straight);
  restoring.diagonal().array() += stiffness;
  const Eigen::GeneralizedSelfAdjointEigenSolver<mechanics::JointMatrix> eigen(restoring, chain.mass_matrix(straight),
                                                                               Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
  return std::sqrt(eigen.eigenvalues().minCoeff()) / two_pi;
}

HingeReference hinge_reference(const Design& design) {
  if (design.calibration.hinge) return *design.calibration.hinge;
  return {.width = prototype_width,
          .bottom_layer = prototype_bottom_layer,
          .stiffness = prototype_stiffness,
          .damping = silicone_damping(design, prototype_stiffness, prototype_first_mode) +
                     constant_damping(design, prototype_width),
          .first_mode = prototype_first_mode};
}

bool has_measured_stiffness(const Design& design) {
  const Calibration& factors = design.calibration;
  if (factors.joint_stiffness == 1.0) return false;
  if (!factors.hinge) return true;
  constexpr double rounding = 1e-9;
  const double now = factors.joint_stiffness * derived_stiffness(design, section_of(*factors.hinge));
  return std::abs(now / factors.hinge->stiffness - 1.0) < rounding;
}

bool has_measured_damping(const Design& design) {
  const Calibration& factors = design.calibration;
  return factors.constant_damping != 1.0 || factors.joint_damping != factors.joint_stiffness;
}

Design with_measured_hinge(Design design, std::optional<double> stiffness, std::optional<double> damping) {
  const Dimensions size = dimensions(design);
  if (stiffness) {
    check_measured(*stiffness, "joint stiffness");
    design.calibration.joint_stiffness *= *stiffness / hinge_stiffness(design, size);
  }
  const double actual = hinge_stiffness(design, size);
  const double first_mode = first_mode_frequency(chain_of(design, segments(design, size)), actual);
  if (damping) {
    check_measured(*damping, "joint damping");
    calibrate_damping(design, *damping, size, first_mode);
  }
  design.calibration.hinge = HingeReference{.width = size.width,
                                            .bottom_layer = design.body.bottom_layer,
                                            .stiffness = actual,
                                            .damping = hinge_damping(design, size, first_mode),
                                            .first_mode = first_mode};
  return design;
}

Design with_hinge_law(Design design, HingeLaw law) {
  const CrossSection section = section_of(hinge_reference(design));
  const double before = derived_stiffness(design, section);
  design.choices.hinge = law;
  const double ratio = before / derived_stiffness(design, section);
  Calibration& factors = design.calibration;
  // Where no stiffness was measured there is nothing for the other law to pass through: it has a level of its own.
  const bool measured = factors.joint_stiffness != 1.0;
  const bool damping_measured = factors.hinge || has_measured_damping(design);
  if (measured) factors.joint_stiffness *= ratio;
  if (!measured && factors.hinge) factors.hinge->stiffness /= ratio;
  if (measured || damping_measured) factors.joint_damping *= ratio;
  return design;
}

DampingSplit damping_split(const Design& design) {
  const HingeReference reference = hinge_reference(design);
  const double silicone = silicone_damping(design, reference.stiffness, reference.first_mode);
  const double all = silicone + constant_damping(design, reference.width);
  return {.law = design.choices.damping, .share = all > 0.0 ? silicone / all : 0.0};
}

Design with_damping(Design design, const DampingSplit& split) {
  if (!(split.share >= 0.0 && split.share <= 1.0))
    throw std::invalid_argument(fmt::format("share of damping must lie in 0 to 1; got {}", split.share));
  const HingeReference reference = hinge_reference(design);
  const double loss_time = split.share * reference.damping / reference.stiffness;
  design.choices.damping = split.law;
  if (split.law == DampingLaw::loss_factor)
    design.body.loss_factor = loss_time * two_pi * reference.first_mode;
  else
    design.body.loss_time = loss_time;
  design.calibration.joint_damping = design.calibration.joint_stiffness;
  design.body.constant_damping = (1.0 - split.share) * reference.damping / volume_scale(reference.width);
  design.calibration.constant_damping = 1.0;
  return design;
}

Design with_face_contact(Design design, ContactChoice faces) {
  design.choices.faces = faces;
  return design;
}

}  // namespace coilwright::actuator
