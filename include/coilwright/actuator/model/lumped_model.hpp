#pragma once

#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "coilwright/actuator/model/as_built.hpp"
#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/actuator/parts/coil_row.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator {

/// A coil and a magnet on the two sides of one joint, by their dimensions. Plain numbers; any combination may be
/// written down.
struct PairDimensions {
  magnetics::ThickCoil::Spec coil{};
  magnetics::CylinderMagnet::Spec magnet{};
  magnetics::HingeGeometry geometry{};
  magnetics::Fidelity fidelity = magnetics::Fidelity::line_of_centres;
};

/// Measured torque per ampere over one joint angle.
struct TorqueTable {
  std::vector<double> angles{};   ///< rad, increasing; at least 4
  std::vector<double> torques{};  ///< N m/A, one per angle
};

/// The magnetics of one joint of a lumped model.
struct LumpedPair {
  int joint{};
  std::variant<PairDimensions, TorqueTable> source{};
};

/// A model that is given by the numbers of its links, joints and pairs instead of by a design. Plain numbers, SI.
struct LumpedModel {
  double gravity{};  ///< m/s^2
  std::vector<mechanics::Link> links{};
  std::vector<Hinge> hinges{};      ///< one per link
  std::vector<LumpedPair> pairs{};  ///< in the order of joints, at most one each, each with a current of its own
  std::vector<Effect> effects{};    ///< each kind at most once
  AsBuilt as_built{};               ///< differences between the built actuator and these numbers
};

/// The parts of a lumped model that take long to compute. Immutable; copies share them.
struct LumpedMagnetics {
  std::vector<HingePair> hinge_pairs{};
  std::shared_ptr<const CoilRow> coil_row{};  ///< see coil_row_of()
};

/// The torque curve of a pair that takes the current of `coil`. For a pair of dimensions it covers -2 to 120 degrees
/// with an error of 1e-6 of its largest torque. For a table it covers the table's angles, within 1e-4, by the rational
/// interpolant without poles of Floater and Hormann (Numerische Mathematik 107, 2007) of degree 3. Throws
/// std::invalid_argument if a number breaks its rule, and the errors of magnetics::torque_curve.
[[nodiscard]] HingePair hinge_pair_of(const LumpedPair& pair, int coil);

/// Applies hinge_pair_of() to each pair, with the current of its index. Throws as that does.
[[nodiscard]] std::vector<HingePair> hinge_pairs_of(std::span<const LumpedPair> pairs);

/// The coils of a lumped model that is a finger of configuration B: two joints with a pair of dimensions on each, one
/// coil on the base, one on the last link, and the magnet between them. Null for any other model, because its numbers
/// do not tell where its coils are. Throws std::invalid_argument if a link breaks its rules.
[[nodiscard]] std::shared_ptr<const CoilRow> coil_row_of(const LumpedModel& model);

/// Computes all parts that take long. Throws as hinge_pair_of() and coil_row_of() do.
[[nodiscard]] LumpedMagnetics magnetics_of(const LumpedModel& model);

/// The specification of the model as it was built. `magnetics` are those of `model`, before errors of its curves.
/// Throws std::invalid_argument if a link breaks its rules, and as as_built() does.
[[nodiscard]] ModelSpec spec_of(const LumpedModel& model, const LumpedMagnetics& magnetics);

}  // namespace coilwright::actuator
