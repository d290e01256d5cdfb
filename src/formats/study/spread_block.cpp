#include "formats/study/spread_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/sizing/study/usual_scatters.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using sizing::Scatter;
using sizing::Spread;

constexpr int fewest_draws = 8;
constexpr int most_draws = 4096;
constexpr Rule any_deviation = Rule::between(-1e6, 1e6);

// {"sd": 0.08}, {"relative_sd": 0.015}, {"uniform": [-1, 1]} or {"relative_uniform": [-0.1, 0.1]}.
Scatter read_scatter(const Node& node, const std::string& name) {
  return read_object(node, [&name](ObjectReader& in) {
    const std::string kind = in.one_of({"sd", "relative_sd", "uniform", "relative_uniform"});
    Scatter out{.name = name, .about = {}, .relative = kind.starts_with("relative_")};
    if (kind.ends_with("sd")) {
      out.about = sizing::NormalDeviation{in.number(kind, positive.and_also(Rule::at_most(out.relative ? 0.25 : 1e6)))};
      return out;
    }
    const std::vector<Node> ends = in.elements(kind, Length::from_to(2, 2));
    const sizing::UniformDeviation uniform{.low = ends[0].number(any_deviation), .high = ends[1].number(any_deviation)};
    if (uniform.high <= uniform.low) throw ends[1].error(fmt::format("must be above the other end ({})", uniform.low));
    if (out.relative && uniform.low <= -1.0) throw ends[0].error("must be above -1: a share of the designed value");
    out.about = uniform;
    return out;
  });
}

[[noreturn]] void refuse_name(const Node& node, const std::string& name, const std::vector<BlockVariable>& of_blocks) {
  std::vector<std::string> names = sizing::operating_number_names();
  names.insert(names.end(), {"parts", "draws"});
  for (const BlockVariable& known : of_blocks) names.push_back(known.name);
  for (const actuator::Parameter& known : actuator::parameters())
    if (!known.whole) names.emplace_back(known.name);
  throw node.error_without_value("is no number of an actuator or a block that may scatter" + did_you_mean(name, names));
}

void add(Spread& spread, Scatter scatter, std::optional<double> block_value) {
  const auto same = std::ranges::find(spread.scatters, scatter.name, &Scatter::name);
  if (same != spread.scatters.end()) {  // what a study says itself counts
    *same = std::move(scatter);
    return;
  }
  spread.scatters.push_back(std::move(scatter));
  spread.block_values.push_back(block_value);
}

void read_scatter_into(Spread& spread, const Node& node, const std::string& name,
                       const std::vector<BlockVariable>& of_blocks) {
  if (const auto block = std::ranges::find(of_blocks, name, &BlockVariable::name); block != of_blocks.end())
    return add(spread, read_scatter(node, name), units::to_memory(block->base, name));
  const actuator::Parameter* parameter = actuator::find_parameter(name);
  const std::vector<std::string> operating = sizing::operating_number_names();
  if (std::ranges::count(operating, name) == 0 && (parameter == nullptr || parameter->whole))
    refuse_name(node, name, of_blocks);
  add(spread, read_scatter(node, name), std::nullopt);
}

}  // namespace

Spread read_spread(const Node& node, const std::vector<BlockVariable>& of_blocks) {
  Spread spread;
  node.expect_object();
  if (const auto parts = node.find("parts")) {
    if (parts->text() != "usual") throw parts->error("must be \"usual\" (coilwright list spreads)");
    for (const sizing::UsualScatter& usual : sizing::usual_scatters()) add(spread, usual.scatter, std::nullopt);
  }
  if (const auto draws = node.find("draws"))
    spread.draws = static_cast<std::size_t>(draws->integer<int>(Rule::between(fewest_draws, most_draws)));
  for (const std::string& name : node.keys())
    if (name != "parts" && name != "draws") read_scatter_into(spread, *node.find(name), name, of_blocks);
  if (spread.scatters.empty()) throw node.error_without_value("needs \"parts\" or a number that scatters");
  return spread;
}

// What no number of a file has to be but a build must: a length or a factor that is there.
void require_buildable(const Node& node, const Spread& spread, const actuator::Design& base) {
  constexpr double one_in_ten_thousand = 1e-4;
  for (const Scatter& scatter : spread.scatters) {
    const actuator::Parameter* parameter = actuator::find_parameter(scatter.name);
    if (parameter == nullptr || scatter.relative || parameter->rule == actuator::ParameterRule::any) continue;
    const double value = units::from_memory(parameter->get(base), parameter->key);
    const double lowest = value + scatter.deviation(one_in_ten_thousand);
    if (lowest > 0.0) continue;
    const auto place = node.find(scatter.name);
    throw(place ? *place : node)
        .error_without_value(
            fmt::format("would make {} {:.3g} in one of 10,000 builds of the study's own actuator ({:.4g}): give less, "
                        "or a relative_sd",
                        scatter.name, lowest, value));
  }
}

}  // namespace coilwright::formats
