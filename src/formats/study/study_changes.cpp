#include "formats/study/study_changes.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "coilwright/formats/actuator/assignment.hpp"
#include "coilwright/text/argument.hpp"

namespace coilwright::formats {

bool is_of_file(std::string_view change) {
  return change.starts_with('/');
}

text::Document changed(text::Document document, const StudyChanges& changes) {
  std::map<std::string, double> numbers;
  for (const std::string& change : changes) {
    if (!is_of_file(change)) continue;
    const text::NameAndValue assignment = text::split_assignment(change, change, "/search/seed=3");
    numbers[std::string(assignment.name)] = text::number_of(change, assignment.value);
    try {
      (void)document.with_numbers(numbers);
    } catch (const std::invalid_argument&) {
      throw text::argument_error(change, "must lead to a number of the study");
    }
  }
  return numbers.empty() ? std::move(document) : document.with_numbers(numbers);
}

actuator::Design changed(actuator::Design design, const sizing::Study& study, const StudyChanges& changes) {
  for (const std::string& change : changes) {
    for (const sizing::StudyVariable& variable : study.variables)
      if (change.starts_with(name_of(variable) + '='))
        throw text::argument_error(
            change, fmt::format("must not set {}, which is a variable of this study", name_of(variable)));
    if (!is_of_file(change)) design = with_assignment(std::move(design), change);
  }
  return design;
}

}  // namespace coilwright::formats
