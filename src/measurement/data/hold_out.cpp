#include "coilwright/measurement/data/hold_out.hpp"

#include <map>
#include <utility>

namespace coilwright::measurement::data {

void hold_out(Dataset& data) {
  if (!data.validate.empty()) return;
  std::map<RunKind, int> met;
  std::vector<Run> kept;
  std::vector<Run> sealed;
  for (Run& run : data.fit) {
    const bool seal = met[run.kind]++ % 4 == 1;
    if (seal) data.held_out.push_back(run.name);
    (seal ? sealed : kept).push_back(std::move(run));
  }
  data.fit = std::move(kept);
  data.validate = SealedRuns(std::move(sealed));
}

}  // namespace coilwright::measurement::data
