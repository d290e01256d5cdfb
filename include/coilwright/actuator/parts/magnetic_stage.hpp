#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coilwright/actuator/parts/coil_currents.hpp"
#include "coilwright/magnetics/curve.hpp"
#include "coilwright/mechanics/joint_vector.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator {

class HingePairParts;

/// A coil and a magnet on the two sides of one joint: torque = sense * current * curve(angle).
struct HingePair {
  int joint{};
  int coil{};
  double sense = 1.0;  ///< product of the two polarities and the magnet's strength
  std::shared_ptr<const magnetics::Curve> torque_per_ampere;  ///< of one joint angle, N m/A, opening positive
  std::shared_ptr<const HingePairParts> parts{};              ///< its parts; null if only a curve is known
  int magnet = -1;                                            ///< index among the magnets; -1: not known
};

/// Two components that are not neighbours: at least one joint and one component lie between them. A coil's strength is
/// its current, a magnet's is 1, and the pair's is the product of both.
///
/// With Orientation::dipoles the pair's energy is strength * W(z) (3 (a.z)(b.z) - a.b) / 2, with W the axial energy at
/// the distance of the centres; this is exact on the axis and far away. With Orientation::ignored the pair pulls along
/// the line of centres with its coaxial force.
struct DistantPair {
  /// Dependence of the pair's energy on the directions of its axes.
  enum class Orientation { ignored, dipoles };

  mechanics::LinkPoint first;
  mechanics::LinkPoint second;
  int coil = -1;         ///< index of the coil whose current scales the pair; -1: two magnets, no current
  int second_coil = -1;  ///< index of a second coil whose current scales it too; -1: not a pair of coils
  double sense = 1.0;    ///< > 0 where like moments (both along the chain at unit current) face each other; magnitude:
                         ///< the product of its magnets' strengths
  int magnet = -1;       ///< index of its magnet among the magnets; -1: none, or not known
  int second_magnet = -1;  ///< index of a second magnet among the magnets; -1: none, or not known
  Orientation orientation = Orientation::dipoles;
  std::shared_ptr<const magnetics::Curve>
      axial_force;  ///< of like moments on the second, N (per A, A^2), of the distance
  std::shared_ptr<const magnetics::Curve>
      axial_energy;  ///< W with -dW/dz = axial_force and W(infinity) = 0, J (per A, A^2)
};

/// Second stage of a model: turns joint angles and coil currents into joint torques.
class MagneticStage {
 public:
  MagneticStage() = default;
  /// Takes the pairs across one joint, and those that are further apart.
  MagneticStage(std::vector<HingePair> hinge_pairs, std::vector<DistantPair> distant_pairs);

  /// Adds the magnetic torque of every joint (N m) at `angles` (rad) to `torques`. Outside its range a curve continues
  /// along its tangent; contacts stop a joint within a few thousandths of a radian of it.
  void add_torques(const mechanics::PlanarChain& chain, const mechanics::JointVector& angles,
                   const CoilCurrents& currents, mechanics::JointVector& torques) const;

  /// Adds the negative slope of the torques by the angles, (n, n), N m/rad, to `stiffness`. Analytic.
  void add_stiffness(const mechanics::PlanarChain& chain, const mechanics::JointVector& angles,
                     const CoilCurrents& currents, mechanics::JointMatrix& stiffness) const;

  /// Returns the same pairs with magnets of other strengths, one per magnet (its polarisation over that of the curves).
  /// Pairs whose magnets are not known stay.
  [[nodiscard]] MagneticStage with_magnet_strengths(std::span<const double> strengths) const;

  [[nodiscard]] const std::vector<HingePair>& hinge_pairs() const noexcept { return hinge_pairs_; }
  [[nodiscard]] const std::vector<DistantPair>& distant_pairs() const noexcept { return distant_pairs_; }

 private:
  void add_distant_torques(const mechanics::PlanarChain& chain, const mechanics::JointVector& angles,
                           const CoilCurrents& currents, mechanics::JointVector& torques) const;
  void add_distant_stiffness(const mechanics::PlanarChain& chain, const mechanics::JointVector& angles,
                             const CoilCurrents& currents, mechanics::JointMatrix& stiffness) const;

  std::vector<HingePair> hinge_pairs_;
  std::vector<DistantPair> distant_pairs_;
};

}  // namespace coilwright::actuator
