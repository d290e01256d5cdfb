#include "coilwright/actuator/design/design.hpp"
#include "coilwright/magnetics/inner_field.hpp"
#include "coilwright/mechanics/silicone_hinge.hpp"

#include <fmt/format.h>

#include <numbers>

namespace coilwright::actuator {

winding::Wire wire_of(const CoilDesign& coil) {
  const winding::Wire wire = coil.wire_diameter > 0.0 ? winding::round_wire(coil.wire_diameter, coil.enamel)
                                                      : winding::gauge(coil.wire_gauge, coil.enamel);
  return coil.wire_overall > 0.0 ? winding::with_overall_diameter(wire, coil.wire_overall) : wire;
}

double wires_section(const CoilDesign& coil) {
  const double diameter = wire_of(coil).insulated_diameter;
  return coil.turns_radial * coil.turns_axial * 0.25 * std::numbers::pi * diameter * diameter;
}

const SiliconeDesign& hinge_silicone(const Design& design) {
  return design.bottom_silicone ? *design.bottom_silicone : design.body;
}

void SiliconeDesign::make_of(const mechanics::SiliconeGrade* material) {
  grade = material;
  if (material == nullptr) return;
  young_modulus = material->young_modulus;
  density = material->density;
}

double SiliconeDesign::modulus() const {
  if (young_modulus > 0.0) return young_modulus;
  return shore_hardness_00 > 0.0 ? mechanics::young_modulus_from_shore_00(shore_hardness_00)
                                 : mechanics::young_modulus_from_shore_a(shore_hardness);
}

std::string SiliconeDesign::name() const {
  constexpr double megapascal = 1e6;
  if (grade != nullptr && young_modulus == grade->young_modulus) return std::string(grade->name);
  if (young_modulus > 0.0) return fmt::format("Young's modulus {:.4g} MPa", young_modulus / megapascal);
  return shore_hardness_00 > 0.0 ? fmt::format("Shore 00-{:.4g}", shore_hardness_00)
                                 : fmt::format("Shore {:.4g}A", shore_hardness);
}

void MagnetDesign::make_of(const magnetics::MagnetGrade* material) {
  MagnetDesign made{.radius = radius,
                    .length = length,
                    .remanence = remanence,
                    .density = density,
                    .temperature_limit = temperature_limit};
  if (material != nullptr) {
    made.grade = material;
    made.remanence = material->remanence;
    made.density = material->density;
    made.temperature_limit = material->temperature_limit;
    made.coercivity = material->coercivity;
    made.remanence_coefficient = material->remanence_coefficient;
    made.coercivity_coefficient = material->coercivity_coefficient;
    made.recoil_permeability = material->recoil_permeability;
  }
  *this = made;
}

double MagnetDesign::polarisation() const {
  return remanence * magnetics::recoil_factor({.radius = radius, .length = length}, recoil_permeability);
}

magnetics::CylinderMagnet MagnetDesign::cylinder() const {
  return magnetics::CylinderMagnet(
      {.radius = radius, .length = length, .remanence = remanence, .recoil_permeability = recoil_permeability});
}

}  // namespace coilwright::actuator
