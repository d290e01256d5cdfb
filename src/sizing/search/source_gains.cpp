#include "sizing/search/source_gains.hpp"

#include <algorithm>

namespace coilwright::sizing {

void SourceGains::learn(const std::vector<Proposal>& proposals, const std::vector<double>& gains) {
  std::array<double, proposal_sources> sum{}, count{};
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const auto source = static_cast<std::size_t>(proposals[i].source);
    sum[source] += gains[i];
    count[source] += 1;
  }
  for (std::size_t source = 0; source < proposal_sources; ++source) {
    if (count[source] > 0) averages_[source] = 0.8 * averages_[source] + 0.2 * sum[source] / count[source];
  }
}

double SourceGains::model_share() const {
  const double model = std::max({of(ProposalSource::gap), of(ProposalSource::anchor), of(ProposalSource::niche)});
  const double other = std::max(of(ProposalSource::evolution), of(ProposalSource::sobol));
  return std::clamp(model / std::max(model + other, 1e-300), 0.5, 0.9);
}

double SourceGains::evolution_share() const {
  const double evolution = of(ProposalSource::evolution), sobol = of(ProposalSource::sobol);
  return std::clamp(evolution / std::max(evolution + sobol, 1e-300), 0.3, 0.85);
}

}  // namespace coilwright::sizing
