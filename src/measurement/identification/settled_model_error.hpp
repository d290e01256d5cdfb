#pragma once

#include <span>

#include "measurement/identification/attribution.hpp"

namespace coilwright::measurement::identification {

/// Weighs priors against the model error of the reported hypothesis of `found` instead of that of the search, and the
/// errors of recorded inputs as that lets them through; takes samples back that are no outliers by it (fit::take_back),
/// and fits it, its rivals and the declared model anew. Changes nothing where both errors are the same, all inputs
/// exact and no sample is taken back. The errors of all are comparable then, and their numbers stay as near to what is
/// declared as the reported one's own error allows.
[[nodiscard]] Attribution with_settled_model_error(std::span<replay::PreparedRun> runs, Attribution found);

}  // namespace coilwright::measurement::identification
