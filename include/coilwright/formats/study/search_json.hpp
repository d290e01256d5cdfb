#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// What became of the designs of an archive.
struct ArchiveCounts {
  std::size_t ok{};
  std::size_t infeasible{};
  std::size_t failed{};
  std::string usual_failure{};  ///< the most frequent reason of those that failed
};
[[nodiscard]] ArchiveCounts counts_of(const sizing::Archive& archive);

/// {"ok": .., "infeasible": .., "failed": ..}
[[nodiscard]] text::Json to_json(const ArchiveCounts& counts);

/// sizing::late_gain(), or null.
[[nodiscard]] text::Json late_gain_json(const sizing::Archive& archive, std::size_t evaluations);

/// The objectives as the study has them: [{"maximise": "stroke_deg"}].
[[nodiscard]] text::Json objectives_asked(const sizing::Study& study);

/// [{"quantity": .., "designs": .., "consequence": ..}]
[[nodiscard]] text::Json to_json(std::span<const sizing::BrokenPartLimit> broken);

/// The first keys of a result file: what was asked, and how it was searched.
[[nodiscard]] text::Json result_head(std::string_view command, const sizing::Study& study, sizing::StopReason reason);

}  // namespace coilwright::formats
