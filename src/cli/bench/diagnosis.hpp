#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "cli/bench/bench.hpp"
#include "cli/bench/newest.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::cli {

/// Whether diagnose has written a folder.
[[nodiscard]] bool has_diagnosis(const std::filesystem::path& folder);

/// Reads the data set of the diagnosis in a folder, whose corrected design is `corrected`, and predicts its runs.
/// Throws InputError if the data set is not where provenance.json names it, or not as it was.
[[nodiscard]] std::shared_ptr<const OpenedDiagnosis> open_diagnosis(const std::filesystem::path& folder,
                                                                    const actuator::Design& corrected);

/// What the page tells of it: "verdict", "channels" (run, role, channel), and "intervals" of 95 %, [lower, upper] by
/// the names of the knobs, with null where the data leave an end open. Throws InputError.
[[nodiscard]] text::Json diagnosis_json(const std::filesystem::path& folder, const OpenedDiagnosis& diagnosis);

/// One of these channels over its axis, in the unit of its name: as measured (null: left out as an outlier), as
/// declared, as corrected and as turned, with the "rmse" of each; null where the turned design cannot be simulated. Of
/// a long run every n-th sample is given; all count in the errors. Throws InputError for a channel that there is not.
[[nodiscard]] text::Json record_of(const Bench& bench, const Turned& design, std::size_t channel);

/// The same errors over all runs, as diagnosis.json groups them: by role and quantity. Throws Superseded between two
/// runs.
[[nodiscard]] text::Json errors_of(const Bench& bench, const Turned& design, const NewestFirst::Turn& turn);

}  // namespace coilwright::cli
