#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace coilwright::page {

/// Of a long record an even choice of samples that a picture can show: at most 1200.
class Thinning {
 public:
  explicit Thinning(std::size_t count);
  [[nodiscard]] std::vector<double> of(const std::vector<double>& values) const;
  /// " One sample in 4 is drawn."; empty where all are.
  [[nodiscard]] std::string text() const;

 private:
  std::size_t stride_;
};

}  // namespace coilwright::page
