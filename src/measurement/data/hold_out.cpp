#include "coilwright/measurement/data/hold_out.hpp"

#include <map>
#include <utility>

namespace coilwright::measurement::data {

Dataset with_runs_held_out(Dataset data) {
  if (!data.validate.empty()) return data;
  std::map<RunKind, int> counts;
  std::vector<Run> kept;
  std::vector<Run> sealed;
  for (Run& run : data.fit) {
    const bool seal = counts[run.kind]++ % 4 == 1;
    if (seal) data.held_out.push_back(run.name);
    (seal ? sealed : kept).push_back(std::move(run));
  }
  data.fit = std::move(kept);
  data.validate = SealedRuns(std::move(sealed));
  return data;
}

}  // namespace coilwright::measurement::data
