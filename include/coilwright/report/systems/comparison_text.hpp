#pragma once

#include <span>

#include "coilwright/report/simulation/document.hpp"
#include "coilwright/systems/validation/paper_comparison.hpp"

namespace coilwright::report {

/// What `validate` says: how many differences between the model and the figures of the paper lie within their bands,
/// and each of them. `rows` must not be empty.
[[nodiscard]] Document document_of(std::span<const systems::validation::Comparison> rows);

}  // namespace coilwright::report
