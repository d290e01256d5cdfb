#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "coilwright/actuator/parts/magnetic_stage.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator {

/// A coil and where its centre is; its axis lies along its link.
struct PlacedCoil {
  magnetics::ThickCoil coil;
  mechanics::LinkPoint centre;
  double polarity = 1.0;  ///< +1 or -1: the sense of its moment at positive current
};

/// All coils of an actuator and the pairs among them. Logically immutable and thread-safe; the pairs' curves are
/// computed on first use and cached.
class CoilRow {
 public:
  /// `coils` base to tip, in the order of their currents, each on a link of its own; at least two. `chain` at angles 0
  /// tells how far apart they are; `curve_tolerance` (> 0) is that of Design. Throws std::invalid_argument where the
  /// links do not rise.
  CoilRow(const mechanics::PlanarChain& chain, std::vector<PlacedCoil> coils, DistantPair::Orientation orientation,
          double curve_tolerance = 1e-6);

  [[nodiscard]] const std::vector<PlacedCoil>& coils() const noexcept { return coils_; }
  /// Every pair of coils. Each force curve has an error of at most the tolerance times its largest value, from 0.9 of
  /// the straight distance on, or from contact on for neighbours that touch later. Safe from any thread.
  [[nodiscard]] std::vector<DistantPair> pairs() const;

 private:
  [[nodiscard]] std::vector<DistantPair> build() const;

  std::vector<PlacedCoil> coils_;
  std::vector<Eigen::Vector2d> straight_;  // centres at angles 0, m
  DistantPair::Orientation orientation_;
  double curve_tolerance_;
  mutable std::mutex mutex_;
  mutable std::vector<DistantPair> pairs_;
};

}  // namespace coilwright::actuator
