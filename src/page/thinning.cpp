#include "page/thinning.hpp"

#include <fmt/format.h>

namespace coilwright::page {
namespace {

constexpr std::size_t most_points = 1200;

}  // namespace

Thinning::Thinning(std::size_t count) : stride_((count + most_points - 1) / most_points) {}

std::vector<double> Thinning::of(const std::vector<double>& values) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < values.size(); i += stride_) out.push_back(values[i]);
  return out;
}

std::string Thinning::text() const {
  return stride_ > 1 ? fmt::format(" One sample in {} is drawn.", stride_) : "";
}

}  // namespace coilwright::page
