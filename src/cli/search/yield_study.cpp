#include "cli/search/yield_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "cli/options.hpp"
#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/formats/study/study_of_one.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

// The numbers of blocks that the study varies, of which nothing else says what the design has.
void require_settings(const sizing::Study& study, const YieldQuestion& question) {
  for (const sizing::StudyVariable& variable : study.variables) {
    if (!std::holds_alternative<sizing::SettingVariable>(variable)) continue;
    const std::string name = name_of(variable);
    const std::string pointer = formats::block_pointer(name).value();
    const bool is_given = std::ranges::any_of(question.changes, [&](const std::string& change) {
      return change.starts_with(name + "=") || change.starts_with(pointer + "=");
    });
    if (!is_given)
      throw text::InputError(
          {.file = question.study.file,
           .place = "/variables/" + name,
           .rule = fmt::format("needs --set {}=VALUE: the study varies it, and no actuator's file says "
                               "what it is",
                               name)});
  }
}

}  // namespace

sizing::Study study_of_one(const YieldQuestion& question) {
  require_names_once(question.changes);
  const text::InputText &file = question.study, &actuator = question.actuator;
  std::vector<std::string> of_study;
  std::vector<std::string> of_actuator;
  // What a block's variable is, no actuator's file says: "driver_voltage_V=8" is /driver/voltage_V=8 of the study.
  for (const std::string& change : question.changes)
    if (const std::optional<std::string> of_block = formats::block_pointer(change))
      of_study.push_back(*of_block);
    else
      (change.starts_with('/') ? of_study : of_actuator).push_back(change);
  sizing::Study study = formats::parse_study(
      file.text, file.file,
      {.changes = of_study, .actuator = &actuator, .posterior = question.posterior ? &*question.posterior : nullptr});
  require_settings(study, question);
  for (const std::string& change : of_actuator) study.base = formats::with_assignment(std::move(study.base), change);
  return formats::study_of_one(std::move(study), file.file,
                               {.option = "--current-A",
                                .set = "--set ",
                                .given = question.current,
                                .actuator = actuator.file,
                                .of_file = formats::parse_actuator(actuator.text, actuator.file).operating_point});
}

}  // namespace coilwright::cli
