#include "formats/study/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/effect_number.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/formats/actuator/parameter_rule.hpp"
#include "coilwright/sizing/study/usual_scatters.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using sizing::Scatter;
using sizing::Spread;

constexpr int fewest_draws = 8;
constexpr int most_draws = 4096;
// What is no name of a number.
constexpr std::array<std::string_view, 6> keys_of_spread{"parts",        "assumptions", "posterior",
                                                         "correlations", "draws",       "share_of_uses"};
constexpr Rule any_deviation = Rule::between(-1e6, 1e6);

// {"sd": 0.08}, {"relative_sd": 0.015}, {"uniform": [-1, 1]} or {"relative_uniform": [-0.1, 0.1]}; of each also "of".
Scatter read_scatter(const Node& node, const std::string& name) {
  return read_object(node, [&name](ObjectReader& in) {
    const std::string kind = in.one_of({"sd", "relative_sd", "uniform", "relative_uniform"});
    Scatter out{
        .name = name, .about = {}, .relative = kind.starts_with("relative_"), .of_use = sizing::is_of_use(name)};
    if (const auto of = in.find("of")) {
      out.of_use = of->choice<bool>({{"part", false}, {"use", true}});
      if (out.of_use && sizing::most_parts(name) > 0)
        throw of->error("must be \"part\": what each joint or magnet has by itself it has for good");
    }
    if (kind.ends_with("sd")) {
      // From a quarter on the scatter is one of the logarithm: a factor e at 1.
      out.about = sizing::NormalDeviation{in.number(kind, positive.and_also(Rule::at_most(out.relative ? 1.5 : 1e6)))};
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
  if (const auto rule = missing_block(name, of_blocks)) throw node.error_without_value(*rule);
  if (actuator::find_parameter(name) != nullptr)
    throw node.error_without_value("is a whole number, of which every build has the designed one: it cannot scatter");
  std::vector<std::string> names = sizing::further_number_names();
  names.insert(names.end(), std::begin(keys_of_spread), std::end(keys_of_spread));
  for (const BlockVariable& known : of_blocks) names.push_back(known.name);
  for (const actuator::Parameter& known : actuator::parameters())
    if (!known.whole) names.emplace_back(known.name);
  throw node.error_without_value("is no number of an actuator or a block that may scatter" + did_you_mean(name, names));
}

void add(Spread& spread, Scatter scatter) {
  const auto same = std::ranges::find(spread.scatters, scatter.name, &Scatter::name);
  if (same != spread.scatters.end())
    *same = std::move(scatter);  // what a study says itself counts
  else
    spread.scatters.push_back(std::move(scatter));
}

void read_scatter_into(Spread& spread, const Node& node, const std::string& name,
                       const std::vector<BlockVariable>& of_blocks) {
  Scatter scatter = read_scatter(node, name);
  if (const auto block = std::ranges::find(of_blocks, name, &BlockVariable::name); block != of_blocks.end()) {
    scatter.block_value = units::to_memory(block->base, name);
    return add(spread, std::move(scatter));
  }
  const actuator::Parameter* parameter = actuator::find_parameter(name);
  const std::vector<std::string> further = sizing::further_number_names();
  const bool of_an_effect = name.find('.') != std::string::npos;
  if (!of_an_effect && std::ranges::count(further, name) == 0 && (parameter == nullptr || parameter->whole))
    refuse_name(node, name, of_blocks);
  const std::size_t parts = sizing::most_parts(name);
  if (parts == 0) return add(spread, std::move(scatter));
  for (; scatter.part < parts; ++scatter.part) spread.scatters.push_back(scatter);
}

// {"of": ["gap_mm", "bottom_layer_mm"], "value": 0.8}: each with each other.
void read_correlation_into(Spread& spread, const Node& node, std::set<std::size_t>& taken) {
  ObjectReader in(node);
  sizing::CorrelatedScatters group;
  for (const Node& name : in.elements("of", Length::at_least(2))) {
    const auto found = std::ranges::find(spread.scatters, name.text(), &Scatter::name);
    if (found == spread.scatters.end()) throw name.error("must be a number that scatters in this spread");
    if (sizing::most_parts(name.text()) > 0) throw name.error("must be one number: each part draws its own of this");
    if (found->of_use)
      throw name.error("must be of a part: every finger meets all that is of a use (\"of\": \"part\")");
    const auto index = static_cast<std::size_t>(found - spread.scatters.begin());
    if (!taken.insert(index).second) throw name.error("must not be correlated twice");
    group.scatters.push_back(index);
    group.name += (group.name.empty() ? "" : " + ") + name.text();
  }
  const auto count = static_cast<Eigen::Index>(group.scatters.size());
  const double lowest = -1.0 / static_cast<double>(count - 1);
  const double value = in.number("value", Rule::between(-1.0, 1.0));
  if (value < lowest)
    throw in.at("value").error(
        fmt::format("must be at least {:.4g}: {} numbers cannot all go against each other", lowest, count));
  in.finish();
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Constant(count, count, value);
  correlation.diagonal().setOnes();
  group.root = sizing::correlation_root(correlation);
  spread.correlated.push_back(std::move(group));
}

// What a diagnosis knows of the actuator that it wrote. Beside what builds scatter: a number may be in both.
void read_posterior_into(Spread& spread, const Node& node, const InputText* text) {
  std::error_code error;
  if (text == nullptr && !std::filesystem::exists(node.path(), error))
    throw node.error(
        fmt::format("must name the diagnosis.json of a diagnosis, and there is no {}", node.path().string()));
  const Document document = text != nullptr ? parse_json(text->text, text->file) : read_json(node.path());
  const Node root = document.root();
  const auto format = root.find("format");
  if (!format || format->kind() != Node::Kind::text || format->text() != "diagnosis/1")
    throw node.error("must name the diagnosis.json of a diagnosis");
  const auto posterior = root.find("posterior");
  if (!posterior)
    throw node.error(
        "must be of a diagnosis that states its numbers together: this one is of an earlier version, "
        "diagnose again");
  if (posterior->is_null()) throw node.error("must be of a design that a diagnosis knows something of");
  ObjectReader in(*posterior);
  sizing::CorrelatedScatters group{.name = "posterior", .scatters = {}, .root = {}};
  const Node numbers = in.at("numbers");
  for (const std::string& name : numbers.keys()) {
    ObjectReader number(*numbers.find(name));
    group.scatters.push_back(spread.scatters.size());
    spread.scatters.push_back({.name = name,
                               .about = sizing::NormalDeviation{number.number("sd", positive)},
                               .measured = number.number("value")});
  }
  const std::size_t count = group.scatters.size();
  Eigen::MatrixXd correlation(count, count);
  const std::vector<Node> rows = in.elements("correlations", Length::exactly(count));
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> row = rows[i].numbers(Length::exactly(count), Rule::between(-1.0, 1.0));
    for (std::size_t j = 0; j < count; ++j)
      correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = row[j];
  }
  try {
    group.root = sizing::correlation_root(correlation);
  } catch (const std::invalid_argument& rule) {
    throw in.at("correlations").error_without_value(rule.what());
  }
  spread.correlated.push_back(std::move(group));
}

// The value of a number that scatters, in the unit of its name, and beyond what no build may have it; nothing for what
// is no number of the study's actuator or blocks.
struct BaseNumber {
  double value{};
  std::optional<double> above{};     // exclusive
  std::optional<double> at_least{};  // inclusive
  std::optional<double> at_most{};   // inclusive
};

std::optional<BaseNumber> number_of(actuator::Design base, const std::vector<BlockVariable>& of_blocks,
                                    std::string_view name) {
  if (const actuator::Parameter* parameter = actuator::find_parameter(name)) {
    const Rule rule = rule_of(*parameter);
    return BaseNumber{.value = units::from_memory(parameter->get(base), parameter->key),
                      .above = parameter->rule == actuator::ParameterRule::any ? std::nullopt : std::optional(0.0),
                      .at_least = parameter->rule != actuator::ParameterRule::length && rule.lower() > 0.0
                                      ? std::optional(rule.lower())
                                      : std::nullopt,
                      .at_most = rule.upper()};
  }
  if (sizing::most_parts(name) > 0) return BaseNumber{.value = 1.0, .above = 0.0};
  if (const actuator::EffectNumber number = actuator::find_effect_number(base, name); number.value != nullptr)
    return BaseNumber{.value = units::from_memory(*number.value, number.parameter->key),
                      .at_least = units::from_memory(number.parameter->lower, number.parameter->key)};
  const auto block = std::ranges::find(of_blocks, name, &BlockVariable::name);
  if (block == of_blocks.end()) return std::nullopt;
  BaseNumber out{.value = block->base};
  if (!block->rule.allows(0.0))
    out.above = 0.0;
  else if (!block->rule.allows(-1e-9))
    out.at_least = 0.0;
  return out;
}

}  // namespace

Spread read_spread(const Node& node, const std::vector<BlockVariable>& of_blocks, const InputText* text) {
  Spread spread;
  node.expect_object();
  if (const auto parts = node.find("parts")) {
    const bool by_hand = parts->text() == "by_hand";
    if (!by_hand && parts->text() != "usual")
      throw parts->error("must be \"usual\" or \"by_hand\" (coilwright list spreads)");
    for (const sizing::UsualScatter& usual :
         sizing::usual_scatters(by_hand ? sizing::Making::by_hand : sizing::Making::printed))
      if (sizing::most_parts(usual.scatter.name) == 0) add(spread, usual.scatter);
  }
  if (const auto draws = node.find("draws"))
    spread.draws = static_cast<std::size_t>(draws->integer<int>(Rule::between(fewest_draws, most_draws)));
  if (const auto share = node.find("share_of_uses"))
    spread.share_of_uses = share->number(Rule::above(0.5).and_also(Rule::at_most(1.0)));
  for (const std::string& name : node.keys())
    if (name != comment_key && std::ranges::find(keys_of_spread, name) == keys_of_spread.end())
      read_scatter_into(spread, *node.find(name), name, of_blocks);
  if (const auto correlations = node.find("correlations")) {
    std::set<std::size_t> taken;
    for (const Node& each : correlations->elements()) read_correlation_into(spread, each, taken);
  }
  if (const auto assumptions = node.find("assumptions"))
    read_object(*assumptions, [&spread](ObjectReader& in) {
      spread.scatters.push_back(
          {.name = "assumptions",
           .about = sizing::OtherChoices{in.number("as_designed", Rule::above(0.0).and_also(Rule::below(1.0)))}});
    });
  if (const auto posterior = node.find("posterior")) read_posterior_into(spread, *posterior, text);
  if (spread.scatters.empty()) throw node.error_without_value("needs \"parts\" or a number that scatters");
  return spread;
}

// What no number of a file has to be but a build must: a length or a factor that is there.
void require_suits(const Node& node, const Spread& spread, const actuator::Design& base,
                   const std::vector<BlockVariable>& of_blocks) {
  constexpr double one_in_ten_thousand = 1e-4;
  constexpr double rounding = 1e-9;
  for (const Scatter& scatter : spread.scatters) {
    const auto place = node.find(scatter.measured ? "posterior" : scatter.name);
    const Node& at = place ? *place : node;
    const std::optional<BaseNumber> number = number_of(base, of_blocks, scatter.name);
    if (!number && (scatter.measured || scatter.name.find('.') != std::string::npos))
      throw at.error_without_value(
          fmt::format("has {}, which is no number of an effect of the study's actuator", scatter.name));
    if (!number) continue;
    if (scatter.measured && std::abs(number->value - *scatter.measured) > rounding * std::abs(*scatter.measured))
      throw at.error_without_value(
          fmt::format("is of another actuator, whose {} is {:.6g}: the study's has {:.6g}; give the actuator.json that "
                      "the diagnosis wrote beside it",
                      scatter.name, *scatter.measured, number->value));
    if (scatter.measured) continue;
    const double most = scatter.deviation(1.0 - one_in_ten_thousand);
    const double highest = scatter.relative ? number->value * (1.0 + most) : number->value + most;
    if (number->at_most && highest > *number->at_most)
      throw at.error_without_value(
          fmt::format("would make {} {:.4g} in one of 10,000 builds of the study's own actuator ({:.4g}), which has at "
                      "most {:.4g}: give less",
                      scatter.name, highest, number->value, *number->at_most));
    if (scatter.relative && place && number->value == 0.0)
      throw at.error_without_value(fmt::format("scatters nothing: {} is 0, and so is any share of it", scatter.name));
    if (scatter.relative) continue;
    if (number->value == 0.0 && (number->above || number->at_least) && scatter.deviation(one_in_ten_thousand) < 0.0)
      throw at.error_without_value(fmt::format(
          "scatters {}, which the study's actuator does not give, or gives as 0, so that half of all builds "
          "would have less than nothing: state it there",
          scatter.name));
    const double lowest = number->value + scatter.deviation(one_in_ten_thousand);
    if ((!number->above || lowest > *number->above) && (!number->at_least || lowest >= *number->at_least)) continue;
    throw at.error_without_value(
        fmt::format("would make {} {:.3g} in one of 10,000 builds of the study's own actuator ({:.4g}): give less, "
                    "or a relative_sd",
                    scatter.name, lowest, number->value));
  }
}

}  // namespace coilwright::formats
