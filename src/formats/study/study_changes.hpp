#pragma once

#include <string_view>

#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::formats {

/// Whether a change is of the study's own file, by a JSON pointer: the others are of its actuator.
[[nodiscard]] bool is_of_file(std::string_view change);

/// The study's file with the numbers and words of those changes. Throws InputError of the argument where it is not of
/// the kind that stands there, or leads to nothing.
[[nodiscard]] text::Document changed(text::Document document, const StudyChanges& changes);

/// The study's actuator with the other changes. Throws InputError where one sets what the study varies, which the
/// search would set again, and as with_assignment().
[[nodiscard]] actuator::Design changed(actuator::Design design, const sizing::Study& study,
                                       const StudyChanges& changes);

}  // namespace coilwright::formats
