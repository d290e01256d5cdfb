#pragma once

#include <optional>
#include <string>

#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::formats {

/// The current of builds of one actuator, and what errors call those who say it.
struct CurrentOfOne {
  std::string option;                                 ///< of `given`: "--current-A"
  std::string set{};                                  ///< by which its caller changes a number of the study: "--set "
  std::optional<double> given{};                      ///< A
  std::string actuator{};                             ///< the file of the actuator
  std::optional<actuator::OperatingPoint> of_file{};  ///< of that file
};

/// `study`, which errors call `file`, with its current standing still where it varies: as given or, otherwise, that of
/// the actuator's file. Throws InputError for a study without a spread, for a current beside one of the study itself,
/// and where nothing says the current.
[[nodiscard]] sizing::Study study_of_one(sizing::Study study, const std::string& file, const CurrentOfOne& current);

}  // namespace coilwright::formats
