#include "cli/model/placed_bodies.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iostream>
#include <vector>

namespace coilwright::cli {

void require_apart(const formats::PairFile& file, const std::string& name) {
  for (std::size_t p = 0; p < file.poses.size(); ++p) {
    const std::vector<magnetics::Body> bodies = file.bodies_at(file.poses[p]);
    // Of the bodies only the last one moves from pose to pose.
    formats::require_apart(file, bodies, p == 0 ? 0 : bodies.size() - 1, p + 1, name);
  }
}

void tell(const report::PairRemarks& remarks, const std::string& name) {
  for (const std::string& sentence : remarks.sentences()) std::cerr << fmt::format("MIND: {}: {}\n", name, sentence);
}

}  // namespace coilwright::cli
