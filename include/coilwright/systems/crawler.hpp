#pragma once

#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/mechanics/floating_chain.hpp"

namespace coilwright::systems {

/// Battery and board in a longer rear part.
struct Payload {
  double mass = 0.023;   ///< kg; finite, > 0. The paper's robot has 91 g, its finger 68 g.
  double length = 0.03;  ///< by which the rear part is longer, m; finite, > 0. The paper does not give it.
};

/// One battery cell.
struct Cell {
  double voltage = 4.2;        ///< V; finite, > 0
  double capacity = 540.0;     ///< C (150 mAh); finite, > 0
  double current_limit = 3.0;  ///< the most that it delivers, A; finite, > 0. 20 times its capacity an hour.
};

/// Friction of the feet on the ground: low where oblique teeth glide, high where they hold.
struct FootFriction {
  double forwards{};   ///< coefficient while a foot slides towards the fingertip; finite, > 0
  double backwards{};  ///< while it slides towards the rear; finite, > 0
};

/// Switching of the coils: all of them in parallel on the cell through one switch.
struct PulseDrive {
  double frequency = 10.0;        ///< of the pulses, Hz; finite, > 0
  double duty = 0.5;              ///< fraction of a period with the switch closed; > 0, < 1
  double lead_resistance = 0.12;  ///< of switch and leads, ohm, which carry the current of all coils; finite, >= 0
};

/// The parts of a crawling robot beside its actuator.
struct CrawlerParts {
  Payload payload{};
  Cell cell{};
  FootFriction friction{};
  PulseDrive drive{};
};

/// Current of one coil of the actuator while the switch is closed and nothing moves, A, with coils at 20 degC; 0
/// without coils.
[[nodiscard]] double pulse_current(const actuator::Assembly& assembly, const CrawlerParts& parts);

/// A crawling robot: an actuator that lies on level ground on its bottom layer, with the payload behind its rear part.
///
/// Coordinates are those of its FloatingChain: the base (link 0) has its axis along -x while the robot lies straight,
/// so forwards is -x, and opening joints press both ends down. Contact points are at the bottom of the rear end, below
/// each joint (on the link behind it) and of the front end. Immutable.
class Crawler {
 public:
  /// Makes the robot. Throws std::invalid_argument naming field, rule and value for parts that break the rules of
  /// CrawlerParts, a pulse whose current at rest exceeds the cell's limit, a model without coils, or one with effects
  /// that act while it runs.
  Crawler(const actuator::Design& design, const actuator::Assembly& assembly, const CrawlerParts& parts);

  [[nodiscard]] const CrawlerParts& parts() const noexcept { return parts_; }
  [[nodiscard]] const actuator::Model& model() const noexcept { return model_; }
  [[nodiscard]] const mechanics::FloatingChain& chain() const noexcept { return chain_; }
  [[nodiscard]] double mass() const noexcept { return chain_.mass(); }                ///< kg
  [[nodiscard]] double coil_resistance() const noexcept { return coil_resistance_; }  ///< of one coil at 20 degC, ohm
  /// The contact points: rear end, below each joint, front end.
  [[nodiscard]] const std::vector<mechanics::LinkPoint>& contact_points() const noexcept { return points_; }
  /// The coordinates of the robot lying straight, with every contact point at height 0.
  [[nodiscard]] mechanics::CoordinateVector lying() const;
  /// Current of one coil while the switch is closed and nothing moves, A.
  [[nodiscard]] double pulse_current() const noexcept;

 private:
  CrawlerParts parts_;
  actuator::Model model_;
  mechanics::FloatingChain chain_;
  double coil_resistance_;
  double bottom_;  // bottom surface below the hinge line, m
  std::vector<mechanics::LinkPoint> points_;
};

}  // namespace coilwright::systems
