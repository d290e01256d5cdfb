#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/formats/actuator/pair_file.hpp"

namespace coilwright::report {

/// Remarks on forces between bodies that the numbers do not show, gathered pose by pose: bodies in one place, edges on
/// faces, a plate that is no mirror.
class PairRemarks {
 public:
  /// Starts without remarks on the poses of `file`, to which it refers.
  explicit PairRemarks(const formats::PairFile& file) : file_(file) {}

  /// Adds the bodies with the last one in its pose number `pose`, from 1.
  void add(const std::vector<magnetics::Body>& bodies, std::size_t pose);
  /// Adds the forces on them.
  void add(const magnetics::Forces& forces);
  /// The remarks, a sentence each; empty if there are none.
  [[nodiscard]] std::vector<std::string> sentences() const;

 private:
  void add_plate(const std::vector<magnetics::Body>& bodies);
  [[nodiscard]] std::string overlaps_text() const;

  const formats::PairFile& file_;
  bool fixed_are_known_{};  // whether of the bodies that do not move some are in one place was looked at
  std::size_t overlapping_{};
  std::vector<std::size_t> first_overlapping_{};  // numbers of poses
  double worst_error_{}, error_{};                // over the largest force; N
  magnetics::PlateLoad plate_{};
  double plate_reach_{};
};

}  // namespace coilwright::report
