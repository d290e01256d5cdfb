#include "coilwright/formats/study/study_of_one.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "coilwright/text/argument.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::formats {
namespace {

// Of a study that says itself which current flows.
std::string way_to_another_current(const sizing::Study& study, std::string_view set) {
  if (std::holds_alternative<sizing::DrivenCurrent>(study.current))
    return fmt::format("another cell drives another one: {}crawler_cell_voltage_V=VALUE", set);
  const bool is_share = std::holds_alternative<sizing::ShareOfLimit>(study.current);
  return fmt::format("{}/operating_point/{}=VALUE changes it", set, is_share ? "share_of_current_limit" : "current_A");
}

}  // namespace

sizing::Study study_of_one(sizing::Study study, const std::string& file, const CurrentOfOne& current) {
  if (!study.spread)
    throw text::InputError({.file = file,
                            .rule = "needs the block \"spread\" ({\"parts\": \"usual\"}): without one every build is "
                                    "the design"});
  if (!std::holds_alternative<sizing::VariedCurrent>(study.current)) {
    if (current.given)
      throw text::argument_error(current.option,
                                 fmt::format("must not be given: the study itself says which current flows; {}",
                                             way_to_another_current(study, current.set)));
    return study;
  }
  if (!current.given && !current.of_file)
    throw text::InputError({.file = current.actuator,
                            .place = "/operating_point",
                            .rule = fmt::format("must be there, or {}: the study varies the current, and does not say "
                                                "with which one",
                                                current.option)});
  std::erase_if(study.variables, [](const sizing::StudyVariable& variable) {
    return std::holds_alternative<sizing::CurrentVariable>(variable);
  });
  study.current = sizing::FixedCurrent{current.given ? *current.given : current.of_file->current};
  return study;
}

}  // namespace coilwright::formats
