#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/formats/actuator/pair_file.hpp"

namespace coilwright::report {

/// What a reader must know of forces between bodies and the numbers do not show, gathered pose by pose: bodies in one
/// place, edges on faces, a plate that is no mirror.
class PairRemarks {
 public:
  /// Of the poses of `file`, which it refers to.
  explicit PairRemarks(const formats::PairFile& file) : file_(file) {}

  /// The bodies in pose number `pose` of the last one, from 1.
  void add(const std::vector<magnetics::Body>& bodies, std::size_t pose);
  /// The forces on them.
  void add(const magnetics::Forces& forces);
  /// A sentence each; empty where there is nothing to know.
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
