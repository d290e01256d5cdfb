#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace coilwright::thermal {

/// The largest number of nodes of a network. It keeps every matrix on the stack, so that a steady state allocates
/// nothing.
inline constexpr int most_nodes = 40;

/// One value for each node, in the order of the network.
using NodeVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_nodes, 1>;
/// Symmetric matrix over the nodes.
using NodeMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_nodes, most_nodes>;

enum class NodeKind { coil, magnet, silicone };

/// One lump: a coil, a magnet or a piece of silicone, at its mean temperature.
struct Node {
  NodeKind kind{};
  double ambient_conductance{};  ///< to ambient, W/K; finite, >= 0
  double heat_capacity{};        ///< J/K; finite, > 0 (only transients use it)
  double resistance{};           ///< of the coil at 20 degC, ohm; > 0 for a coil, 0 for other nodes
  double temperature_limit{};    ///< of the hot spot, degC; finite; not used for silicone
  /// Rise of the hottest place above the mean per heat that leaves the node, K/W; finite, >= 0; 0 for a node of uniform
  /// temperature.
  double hot_spot_resistance{};
  double current_share = 1.0;  ///< of a coil in the current of its actuator, by which limits are stated; finite
};

/// Conductance between two nodes.
struct Link {
  std::size_t first{};   ///< index of a node
  std::size_t second{};  ///< of another one
  double conductance{};  ///< W/K; finite, >= 0
};

/// Lumps linked to each other and to ambient. Temperatures are in degC throughout. All conductances are constants, so
/// radiation and natural convection are linearised in them, and only differences of temperature enter.
///
/// A coil makes heat (share I)^2 R20 (1 + alpha (T - 20)), I being the actuator's current. It grows with temperature,
/// which makes a runaway possible.
class Network {
 public:
  /// Inputs of a Network.
  struct Spec {
    std::vector<Node> nodes;           ///< 1 to most_nodes
    std::vector<Link> links;           ///< any number; those between the same nodes add up
    double ambient{};                  ///< degC; finite, and such that copper's linear law holds (> 20 - 1/alpha)
    double temperature_coefficient{};  ///< alpha of the coils' resistance about 20 degC, 1/K; finite, > 0
  };
  /// Makes the network. Throws std::invalid_argument naming the field, the rule and the value received; also if some
  /// node has no path to ambient, because its temperature would have no steady value.
  explicit Network(Spec spec);

  [[nodiscard]] const std::vector<Node>& nodes() const noexcept { return spec_.nodes; }
  [[nodiscard]] Eigen::Index size() const noexcept { return static_cast<Eigen::Index>(spec_.nodes.size()); }
  [[nodiscard]] double ambient() const noexcept { return spec_.ambient; }                                  ///< degC
  [[nodiscard]] double temperature_coefficient() const noexcept { return spec_.temperature_coefficient; }  ///< 1/K
  /// Conductance matrix (n, n), W/K: symmetric, positive definite. Heat leaving the nodes is G (T - ambient).
  [[nodiscard]] const NodeMatrix& conductance() const noexcept { return conductance_; }
  /// Heat of each node at ambient temperature per mean square of the actuator's current, ohm: share^2 R20 (1 + alpha
  /// (ambient - 20)).
  [[nodiscard]] NodeVector ambient_resistance() const;
  /// Growth of that heat per kelvin, ohm/K: share^2 alpha R20.
  [[nodiscard]] NodeVector resistance_slope() const;
  /// Temperature of the hottest place of each node, degC, at mean `temperatures` (degC, one per node): mean plus
  /// hot-spot resistance times the heat that leaves the node, once its inner profile has formed.
  [[nodiscard]] NodeVector hot_spots(const NodeVector& temperatures) const;

 private:
  [[nodiscard]] NodeVector heating_resistance() const;  // share^2 R20

  Spec spec_;
  NodeMatrix conductance_;
};

/// A current that is on for a fraction of each period and off for the rest.
struct DutyCycle {
  double current{};  ///< while on, A; finite
  double duty{};     ///< fraction of the period, dimensionless; 0 to 1
};

/// Mean square of a duty cycle, A^2: current^2 duty. It represents the cycle in temperatures if the period is much
/// shorter than the shortest thermal time constant (1 / the last of Transient::rates); the ripple about the mean is
/// then of the order period / time constant. Throws std::invalid_argument naming the field, the rule and the value.
[[nodiscard]] double mean_square(const DutyCycle& cycle);

/// The same mean square current (A^2, >= 0) in every coil of `network`, zero in other nodes.
[[nodiscard]] NodeVector same_in_every_coil(const Network& network, double mean_square_current);

}  // namespace coilwright::thermal
