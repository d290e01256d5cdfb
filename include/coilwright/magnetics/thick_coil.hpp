#pragma once

namespace coilwright::magnetics {

/// The assumed distribution of the current in a thick coil. The total is turns_radial * turns_axial turns in each case;
/// on the prototype finger the three differ by 1.05 % in force.
enum class CurrentDistribution {
  paper_shells,   ///< turns_radial thin shells from the inner to the outer radius, both included (a single one: at the
                  ///< mean radius); the source paper's eq. (14)
  layer_centres,  ///< turns_radial thin shells in the middle of turns_radial layers of equal thickness
  uniform         ///< uniform current density over the whole cross-section
};

/// Circular winding of rectangular cross-section. Immutable; copies are cheap.
class ThickCoil {
 public:
  /// Inputs of a ThickCoil. Name every field at the call site.
  struct Spec {
    double inner_radius{};                                       ///< m; finite, > 0
    double outer_radius{};                                       ///< m; finite, > inner_radius
    double length{};                                             ///< m, along the axis; finite, > 0
    int turns_radial{};                                          ///< layers, dimensionless; >= 1
    int turns_axial{};                                           ///< turns in each layer, dimensionless; >= 1
    CurrentDistribution winding = CurrentDistribution::uniform;  ///< distribution of the current
  };
  /// Makes the coil. Throws std::invalid_argument naming the field, the rule and the value received.
  explicit ThickCoil(const Spec& spec);

  [[nodiscard]] double inner_radius() const noexcept { return spec_.inner_radius; }  ///< m
  [[nodiscard]] double outer_radius() const noexcept { return spec_.outer_radius; }  ///< m
  [[nodiscard]] double length() const noexcept { return spec_.length; }              ///< m
  [[nodiscard]] int turns_radial() const noexcept { return spec_.turns_radial; }     ///< layers
  [[nodiscard]] int turns_axial() const noexcept { return spec_.turns_axial; }       ///< turns in each layer
  [[nodiscard]] CurrentDistribution winding() const noexcept { return spec_.winding; }
  [[nodiscard]] double turns() const noexcept;  ///< all turns, turns_radial * turns_axial

 private:
  Spec spec_;
};

}  // namespace coilwright::magnetics
