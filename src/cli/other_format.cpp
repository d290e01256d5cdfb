#include "cli/other_format.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "coilwright/text/one_line.hpp"

namespace coilwright::cli {
namespace {

struct OtherFormat {
  std::string_view name;
  std::string_view what;
  std::string_view next;  // {}: the file
};

constexpr std::string_view about_actuators = "a study that is about it has its name: coilwright init study writes one";
constexpr std::array formats{
    OtherFormat{"study/1", "a study", "coilwright size {} --out results finds its design, results/actuator.json"},
    OtherFormat{"actuator/1", "an actuator", about_actuators},
    OtherFormat{"lumped-model/1", "an actuator", "coilwright simulate takes it, and diagnose beside its records"},
    OtherFormat{"measured-data/1", "a data set", "coilwright diagnose {} --out results says what its records show"},
    OtherFormat{"experiment/1", "an experiment", "coilwright plan and twin take it, each with an actuator"},
    OtherFormat{"lens/1", "a lens", "coilwright track takes it: --lens {}"},
    OtherFormat{"part/1", "a part of a run", "coilwright merge takes the folders of all parts"}};

}  // namespace

text::InputError with_next_step(const text::InputError& error) {
  text::Fault fault = error.fault();
  if (fault.place != "/format") return error;
  for (const OtherFormat& each : formats)
    if (fault.value == "text " + text::in_quotes(each.name) && fault.rule.find(each.name) == std::string::npos) {
      fault.rule += fmt::format("; this is {}: {}", each.what, fmt::format(fmt::runtime(each.next), fault.file));
      return text::InputError(fault);
    }
  return error;
}

}  // namespace coilwright::cli
