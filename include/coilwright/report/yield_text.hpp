#pragma once

#include <string>
#include <vector>

#include "coilwright/report/simulation/document.hpp"
#include "coilwright/sizing/study/yield.hpp"

namespace coilwright::report {

/// A share of the uses in words: "in every use", or "in 99 % of uses"; > 0 and <= 1.
[[nodiscard]] std::string uses_text(double share);

/// What the builds of a design are: how many keep every limit, why some have no figures, each quantity between its
/// percentiles beside its limit, and which scatter decides.
[[nodiscard]] std::vector<Section> builds_sections(const sizing::Yield& yield);

/// A caution for each limit that fewer builds keep than the study asks for, beyond the error of the dice.
[[nodiscard]] std::vector<std::string> shortfalls_of(const sizing::Yield& yield);

/// The document of `yield`: the sections and cautions above.
[[nodiscard]] Document document_of(const sizing::Yield& yield);

}  // namespace coilwright::report
