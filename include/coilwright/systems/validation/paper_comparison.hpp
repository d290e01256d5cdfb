#pragma once

#include <string>
#include <vector>

namespace coilwright::systems::validation {

/// One number of the paper, or of its checked errata, beside the model's.
struct Comparison {
  std::string quantity;  ///< name, with the unit of both values at its end
  std::string source;    ///< place of the reference in the paper
  double reference{};    ///< in that unit
  double model{};        ///< in that unit
  double band_low{};     ///< model over reference may lie between band_low
  double band_high{};    ///< and band_high
  std::string because;   ///< reason of the difference

  /// Model over reference.
  [[nodiscard]] double ratio() const { return model / reference; }
  /// Whether the ratio lies in its band.
  [[nodiscard]] bool holds() const { return ratio() >= band_low && ratio() <= band_high; }
};

/// Every figure of the paper with which the model can be compared: Tables I and II from geometry alone, then forces,
/// angles, speeds and grasps of the calibrated finger, then the effect of closing a known gap of the model.
[[nodiscard]] std::vector<Comparison> compare_with_paper();

}  // namespace coilwright::systems::validation
