#include "report/search_text.hpp"

#include <fmt/format.h>

namespace coilwright::report {

std::string to_text(const formats::ArchiveCounts& counts) {
  return fmt::format("{} kept every limit, {} did not, {} could not be evaluated", counts.ok, counts.infeasible,
                     counts.failed);
}

std::string_view meaning_of(sizing::StopReason reason) {
  switch (reason) {
    case sizing::StopReason::evaluation_limit:
      return "the evaluations allowed were made";
    case sizing::StopReason::space_exhausted:
      return "every design there is was evaluated";
    case sizing::StopReason::converged:
      return "the algorithm saw nothing left to gain";
    case sizing::StopReason::interrupted:
      return "it was interrupted";
  }
  return "";
}

}  // namespace coilwright::report
