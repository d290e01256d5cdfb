#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/input_text.hpp"

namespace coilwright::cli {

/// What a yield is asked about.
struct YieldQuestion {
  text::InputText study;
  text::InputText actuator;
  std::optional<text::InputText> posterior{};  ///< nothing: the study's own file, if it has one
  std::vector<std::string> changes{};          ///< each --set
  std::optional<double> current{};             ///< A
};

/// The study, with whatever it varies standing still: its actuator is the one given, at the current that its file
/// states. Throws InputError.
[[nodiscard]] sizing::Study study_of_one(const YieldQuestion& question);

}  // namespace coilwright::cli
