#include "coilwright/actuator/modelling_choices.hpp"

namespace coilwright::actuator {
namespace {

OtherChoice winding_otherwise(const Design& design) {
  const bool uniform = design.choices.winding == magnetics::CurrentDistribution::uniform;
  OtherChoice out{.subject = "current in the winding",
                  .taken = uniform ? "spread evenly over the section" : "in the layers of the source paper",
                  .otherwise = uniform ? "in the layers of the source paper, both ends included" : "spread evenly",
                  .settled_by = "the force between one coil and its magnet at two distances",
                  .design = design};
  out.design.choices.winding =
      uniform ? magnetics::CurrentDistribution::paper_shells : magnetics::CurrentDistribution::uniform;
  return out;
}

}  // namespace

std::vector<OtherChoice> other_choices(const Design& design) {
  return {winding_otherwise(design)};
}

}  // namespace coilwright::actuator
