#include "sizing/search/search_context.hpp"

namespace coilwright::sizing {

void report_progress(const SearchContext& context) {
  if (!context.options.progress) return;
  context.options.progress({.evaluations = context.archive.size(),
                            .max_evaluations = context.options.max_evaluations,
                            .feasible = context.samples.feasible_count(),
                            .front_size = context.samples.front().size()});
}

}  // namespace coilwright::sizing
