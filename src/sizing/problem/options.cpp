#include "coilwright/sizing/problem/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace coilwright::sizing {
namespace {

constexpr std::array<std::pair<Algorithm, std::string_view>, 11> algorithm_names{{{Algorithm::automatic, "automatic"},
                                                                                  {Algorithm::cobyla, "cobyla"},
                                                                                  {Algorithm::bobyqa, "bobyqa"},
                                                                                  {Algorithm::sbplx, "sbplx"},
                                                                                  {Algorithm::neldermead, "neldermead"},
                                                                                  {Algorithm::slsqp, "slsqp"},
                                                                                  {Algorithm::mma, "mma"},
                                                                                  {Algorithm::isres, "isres"},
                                                                                  {Algorithm::crs2, "crs2"},
                                                                                  {Algorithm::esch, "esch"},
                                                                                  {Algorithm::direct_l, "direct_l"}}};

}  // namespace

std::string_view name_of(Algorithm algorithm) {
  return std::ranges::find(algorithm_names, algorithm, &std::pair<Algorithm, std::string_view>::first)->second;
}

Algorithm algorithm_named(std::string_view name) {
  const auto found = std::ranges::find(algorithm_names, name, &std::pair<Algorithm, std::string_view>::second);
  if (found != algorithm_names.end()) return found->first;
  std::vector<std::string_view> known;
  for (const auto& entry : algorithm_names) known.push_back(entry.second);
  throw std::invalid_argument(fmt::format("algorithm: must be one of {}; got \"{}\"", fmt::join(known, ", "), name));
}

const std::vector<Algorithm>& algorithms() {
  static const std::vector<Algorithm> all = [] {
    std::vector<Algorithm> list;
    for (const auto& entry : algorithm_names) list.push_back(entry.first);
    return list;
  }();
  return all;
}

std::string_view name_of(StopReason reason) {
  switch (reason) {
    case StopReason::evaluation_limit:
      return "evaluation_limit";
    case StopReason::space_exhausted:
      return "space_exhausted";
    case StopReason::converged:
      return "converged";
    case StopReason::interrupted:
      return "interrupted";
  }
  return "unknown";
}

}  // namespace coilwright::sizing
