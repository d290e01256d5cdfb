#include "coilwright/sizing/study/spread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/sobol.hpp>
#include <boost/random/uniform_01.hpp>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "coilwright/actuator/design/effect_number.hpp"
#include "coilwright/actuator/design/value_limits.hpp"
#include "coilwright/actuator/modelling_choices.hpp"
#include "coilwright/algebra/spectral.hpp"
#include "coilwright/mechanics/joint_vector.hpp"
#include "coilwright/simulation/supply.hpp"
#include "coilwright/units/unit.hpp"
#include "sizing/study/builds.hpp"
#include "sizing/study/evaluate_design.hpp"

namespace coilwright::sizing {
namespace {

constexpr double cut = 4.0;  // standard deviations
// A hundred times a design's own, with which the curves were 60 % of a build's cost: percentiles move by up to
// 5e-6 of themselves.
constexpr double curve_tolerance_of_builds = 1e-4;
constexpr std::uint64_t seed_of_builds = 20260101;
constexpr std::string_view mean_prefix = "mean_";
constexpr std::string_view deviation_prefix = "sd_";
constexpr std::string_view worst_prefix = "worst_";
// Surroundings, how long it is on, what is held or crawled on, and the charge of what feeds the coils.
constexpr std::array<std::string_view, 16> numbers_of_use{"ambient_degC",
                                                          "duty",
                                                          "grasp_opening_deg",
                                                          "supply_voltage_V",
                                                          "driver_voltage_V",
                                                          "gripper_width_mm",
                                                          "gripper_height_mm",
                                                          "gripper_mass_g",
                                                          "gripper_friction",
                                                          "gripper_centre_x_mm",
                                                          "gripper_centre_below_palm_mm",
                                                          "gripper_acceleration_m_s2",
                                                          "crawler_friction_forwards",
                                                          "crawler_friction_backwards",
                                                          "crawler_cell_voltage_V",
                                                          "crawler_payload_mass_g"};

std::vector<double> random_vector(boost::random::mt19937_64& generator, std::size_t dimension) {
  boost::random::uniform_01<double> uniform;
  std::vector<double> out(dimension);
  for (double& value : out) value = uniform(generator);
  return out;
}

double inside(double share) {
  constexpr double least = 1e-12;
  return std::clamp(share, least, 1.0 - least);
}

double normal_quantile(double share) {
  return boost::math::quantile(boost::math::normal(), inside(share));
}

// Shares of the scatters that move together, from independent ones.
std::vector<double> correlated(const Spread& spread, std::span<const double> shares) {
  std::vector<double> out(shares.begin(), shares.end());
  for (const CorrelatedScatters& group : spread.correlated) {
    Eigen::VectorXd deviates(static_cast<Eigen::Index>(group.scatters.size()));
    for (Eigen::Index i = 0; i < deviates.size(); ++i)
      deviates[i] = normal_quantile(shares[group.scatters[static_cast<std::size_t>(i)]]);
    deviates = group.root * deviates;
    for (Eigen::Index i = 0; i < deviates.size(); ++i)
      out[group.scatters[static_cast<std::size_t>(i)]] = boost::math::cdf(boost::math::normal(), deviates[i]);
  }
  return out;
}

double displaced(double value, const Scatter& scatter, double share) {
  const double deviation = scatter.deviation(share);
  return scatter.relative ? value * (1.0 + deviation) : value + deviation;
}

// A number of the operating point, in the unit of its name.
struct OperatingNumber {
  std::string_view name;
  double (*get)(const actuator::OperatingPoint&);
  void (*set)(actuator::OperatingPoint&, double);
};

constexpr std::array operating_numbers{
    OperatingNumber{.name = "current_A",
                    .get = [](const actuator::OperatingPoint& point) { return point.current; },
                    .set = [](actuator::OperatingPoint& point, double value) { point.current = value; }},
    OperatingNumber{
        .name = "duty",
        .get = [](const actuator::OperatingPoint& point) { return point.duty; },
        .set = [](actuator::OperatingPoint& point, double value) { point.duty = std::clamp(value, 0.0, 1.0); }},
    OperatingNumber{
        .name = "grasp_opening_deg",
        .get =
            [](const actuator::OperatingPoint& point) {
              return units::from_memory(point.grasp.opening, "grasp_opening_deg");
            },
        .set = [](actuator::OperatingPoint& point,
                  double value) { point.grasp.opening = std::max(0.0, units::to_memory(value, "grasp_opening_deg")); }},
    OperatingNumber{
        .name = "supply_voltage_V",
        .get = [](const actuator::OperatingPoint& point) { return point.supply.voltage.value(); },
        .set = [](actuator::OperatingPoint& point, double value) { point.supply.voltage = std::max(1e-6, value); }},
};

const OperatingNumber* find_operating_number(std::string_view name) {
  const auto found = std::ranges::find(operating_numbers, name, &OperatingNumber::name);
  return found == operating_numbers.end() ? nullptr : &*found;
}

// A factor that each joint or magnet of a build draws for itself.
struct PartNumber {
  std::string_view name;
  std::vector<double> actuator::AsBuilt::*factors;
  std::size_t most;
  std::size_t (*count)(const actuator::Layout&);
};

constexpr std::array part_numbers{
    PartNumber{.name = "each_joint_stiffness_factor",
               .factors = &actuator::AsBuilt::joint_stiffness_factors,
               .most = mechanics::max_joints,
               .count = [](const actuator::Layout& layout) { return layout.size() - 1; }},
    PartNumber{
        .name = "each_remanence_factor",
        .factors = &actuator::AsBuilt::remanence_factors,
        .most = mechanics::max_joints / 2 + 1,  // no two are neighbours
        .count =
            [](const actuator::Layout& layout) { return static_cast<std::size_t>(actuator::magnet_count(layout)); }},
};

const PartNumber* find_part_number(std::string_view name) {
  const auto found = std::ranges::find(part_numbers, name, &PartNumber::name);
  return found == part_numbers.end() ? nullptr : &*found;
}

// The design by another modelling choice, where the share falls on one.
void choose(actuator::Design& design, const OtherChoices& about, double share) {
  if (share < about.as_designed) return;
  std::vector<actuator::OtherChoice> choices = actuator::other_choices(design);
  const double place = (share - about.as_designed) / (1.0 - about.as_designed) * static_cast<double>(choices.size());
  design = std::move(choices[std::min(static_cast<std::size_t>(place), choices.size() - 1)].design);
}

// Nothing that is built has a length of 0; what else would leave its range says so when it is assembled.
double kept_in_range(double value, actuator::ParameterRule rule) {
  using enum actuator::ParameterRule;
  if (rule == length) return std::max(value, actuator::shortest_length);
  return rule == positive || rule == not_negative ? std::max(value, 0.0) : value;
}

// A build of which the supply cannot drive the current does nothing of what was computed at it.
DesignResult driven(DesignResult result) {
  const auto* design = std::get_if<EvaluatedDesign>(&result);
  if (design == nullptr || !design->point.supply.voltage) return result;
  const simulation::ResultQuantity& supply_load = simulation::supply_load();
  const std::optional<double> load = supply_load.value(design->view());
  if (!load) return without_value(supply_load, design->view());
  if (*load <= 1.0) return result;
  return NotEvaluated{.reason =
                          "the supply has not the voltage to drive the current: raise supply_voltage_V, or lower "
                          "the current",
                      .infeasibility = *load - 1.0};
}

std::vector<std::vector<std::optional<double>>> values_of_builds(const Spread& spread,
                                                                 const std::vector<AskedOfBuild>& asked,
                                                                 const simulation::DesignView& design) {
  std::vector<std::vector<std::optional<double>>> out(asked.size());
  const std::vector<Use> uses = worst_uses(spread, design, asked);
  for (const std::vector<double>& shares : sobol_shares(spread.scatters.size(), spread.draws, seed_of_builds)) {
    const Build build = build_of(spread, design, asked, uses, shares);
    for (std::size_t i = 0; i < asked.size(); ++i) out[i].push_back(build.values[i]);
  }
  return out;
}

std::optional<double> mean_of(const std::vector<std::optional<double>>& values) {
  double sum = 0.0;
  for (const std::optional<double>& value : values) {
    if (!value) return std::nullopt;
    sum += *value;
  }
  return sum / static_cast<double>(values.size());
}

std::optional<double> deviation_of(const std::vector<std::optional<double>>& values) {
  const std::optional<double> mean = mean_of(values);
  if (!mean) return std::nullopt;
  double sum = 0.0;
  for (const std::optional<double>& value : values) sum += (*value - *mean) * (*value - *mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

// At which end of all values a percentile looks for what is bad.
bool counts_low_values(const Statistic& statistic) {
  return statistic.percent < 50;
}

std::optional<double> value_of(const Statistic& statistic, const std::vector<std::optional<double>>& values) {
  switch (statistic.kind) {
    case Statistic::Kind::mean:
      return mean_of(values);
    case Statistic::Kind::deviation:
      return deviation_of(values);
    case Statistic::Kind::percentile:
      break;
  }
  return percentile(values, statistic.percent);
}

std::string meaning_of(const Statistic& statistic, std::size_t draws, bool in_every_use) {
  switch (statistic.kind) {
    case Statistic::Kind::mean:
      return fmt::format("mean over {} builds of the spread", draws);
    case Statistic::Kind::deviation:
      return fmt::format("standard deviation over {} builds of the spread", draws);
    case Statistic::Kind::percentile:
      break;
  }
  if (in_every_use && !counts_low_values(statistic))
    return fmt::format("what {} % of {} builds of the spread stay below in every use", statistic.percent, draws);
  if (in_every_use)
    return fmt::format("what {} % of {} builds of the spread reach in every use", 100 - statistic.percent, draws);
  return fmt::format("what {} % of {} builds of the spread stay below", statistic.percent, draws);
}

}  // namespace

std::vector<std::string> further_number_names() {
  std::vector<std::string> out;
  for (const OperatingNumber& number : operating_numbers) out.emplace_back(number.name);
  for (const PartNumber& number : part_numbers) out.emplace_back(number.name);
  return out;
}

std::size_t most_parts(std::string_view name) {
  const PartNumber* number = find_part_number(name);
  return number == nullptr ? 0 : number->most;
}

bool is_of_use(std::string_view name) {
  return std::ranges::count(numbers_of_use, name) > 0;
}

bool has_uses(const Spread& spread) {
  return std::ranges::any_of(spread.scatters, &Scatter::of_use);
}

double share_of_uses(const Spread& spread) {
  const bool endless = std::ranges::any_of(spread.scatters, [](const Scatter& each) {
    return each.of_use && std::holds_alternative<NormalDeviation>(each.about);
  });
  return endless ? spread.share_of_uses : 1.0;
}

Eigen::MatrixXd correlation_root(const Eigen::MatrixXd& correlation) {
  constexpr double rounding = 1e-9;
  const algebra::SymmetricModes modes = algebra::symmetric_modes(correlation);
  if (modes.values.minCoeff() < -rounding)
    throw std::invalid_argument("no numbers can be correlated so: what some of them imply contradicts others");
  return modes.vectors * modes.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

double Scatter::deviation(double share) const {
  if (const auto* uniform = std::get_if<UniformDeviation>(&about))
    return uniform->low + share * (uniform->high - uniform->low);
  const boost::math::normal standard;
  const double outside = boost::math::cdf(standard, -cut);
  const double normal = std::get<NormalDeviation>(about).sd *
                        boost::math::quantile(standard, outside + inside(share) * (1.0 - 2.0 * outside));
  return relative && std::get<NormalDeviation>(about).sd > most_normal_share ? std::expm1(normal) : normal;
}

std::vector<std::vector<double>> sobol_shares(std::size_t dimension, std::size_t count, std::uint64_t seed) {
  boost::random::mt19937_64 generator(seed);
  const std::vector<double> move = random_vector(generator, dimension);
  boost::random::sobol sequence(std::max<std::size_t>(dimension, 1));
  boost::random::uniform_01<double> uniform;
  std::vector<std::vector<double>> out(count, std::vector<double>(dimension));
  for (std::vector<double>& place : out)
    for (std::size_t i = 0; i < dimension; ++i) {
      const double moved = uniform(sequence) + move[i];
      place[i] = inside(moved - std::floor(moved));
    }
  return out;
}

std::vector<std::vector<double>> random_shares(std::size_t dimension, std::size_t count, std::uint64_t seed) {
  boost::random::mt19937_64 generator(seed);
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < count; ++i) {
    out.push_back(random_vector(generator, dimension));
    for (double& share : out.back()) share = inside(share);
  }
  return out;
}

DesignResult built(const Spread& spread, const simulation::DesignView& design, std::span<const double> independent) {
  actuator::Design other = design.design;
  other.curve_tolerance = curve_tolerance_of_builds;
  actuator::OperatingPoint point = design.point;
  simulation::Settings settings = simulation::settings_of(design);
  const std::vector<double> shares = correlated(spread, independent);
  for (std::size_t i = 0; i < spread.scatters.size(); ++i)
    if (const auto* about = std::get_if<OtherChoices>(&spread.scatters[i].about)) choose(other, *about, shares[i]);
  for (std::size_t i = 0; i < spread.scatters.size(); ++i) {
    const Scatter& scatter = spread.scatters[i];
    if (std::holds_alternative<OtherChoices>(scatter.about)) continue;
    if (const OperatingNumber* number = find_operating_number(scatter.name)) {
      number->set(point, displaced(number->get(point), scatter, shares[i]));
    } else if (const PartNumber* of_part = find_part_number(scatter.name)) {
      std::vector<double>& factors = other.as_built.*of_part->factors;
      factors.resize(of_part->count(other.layout), 1.0);
      if (scatter.part < factors.size())
        factors[scatter.part] = std::max(0.0, displaced(factors[scatter.part], scatter, shares[i]));
    } else if (const actuator::Parameter* parameter = actuator::find_parameter(scatter.name)) {
      const double value = units::from_memory(parameter->get(other), parameter->key);
      parameter->set(other, kept_in_range(units::to_memory(displaced(value, scatter, shares[i]), parameter->key),
                                          parameter->rule));
    } else if (const actuator::EffectNumber effect = actuator::find_effect_number(other, scatter.name);
               effect.value != nullptr) {
      const double value = units::from_memory(*effect.value, effect.parameter->key);
      *effect.value = std::clamp(units::to_memory(displaced(value, scatter, shares[i]), effect.parameter->key),
                                 effect.parameter->lower, effect.parameter->upper);
    } else {
      const auto set = settings.find(scatter.name);
      const double value = set != settings.end() ? set->second : scatter.block_value.value();
      settings.insert_or_assign(
          scatter.name,
          units::to_memory(displaced(units::from_memory(value, scatter.name), scatter, shares[i]), scatter.name));
    }
  }
  return driven(evaluate_design(
      std::move(other), std::move(settings),
      [&](const actuator::Design&, const actuator::Assembly& assembly, const auto& set) {
        if (spread.driven.drive) {
          const DrivenCurrent::Drive drive = spread.driven.drive(assembly, set);
          point.current = drive.current;
          point.duty = drive.duty;
        }
        return point;
      },
      spread.driver));
}

std::optional<StatisticName> statistic_named(std::string_view name) {
  for (const auto& [prefix, kind] :
       {std::pair{mean_prefix, Statistic::Kind::mean}, std::pair{deviation_prefix, Statistic::Kind::deviation}})
    if (name.starts_with(prefix))
      return StatisticName{.statistic = {.kind = kind}, .quantity = std::string(name.substr(prefix.size()))};
  if (name.size() < 5 || name[0] != 'p' || name[3] != '_') return std::nullopt;
  int percent = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + 3, percent);
  if (error != std::errc() || end != name.data() + 3 || percent < 1) return std::nullopt;
  name.remove_prefix(4);
  const bool of_worst_use = name.starts_with(worst_prefix);
  if (of_worst_use) name.remove_prefix(worst_prefix.size());
  return StatisticName{.statistic = {.kind = Statistic::Kind::percentile, .percent = percent},
                       .of_worst_use = of_worst_use,
                       .quantity = std::string(name)};
}

std::optional<simulation::ResultQuantity> quantity_of(const StatisticName& name,
                                                      const simulation::QuantityTable& known) {
  const simulation::ResultQuantity* of = known.find(name.quantity);
  // One name for one thing.
  if (of == nullptr || (name.of_worst_use && of->in_every_use)) return std::nullopt;
  simulation::ResultQuantity out = *of;
  out.in_every_use = name.statistic.kind == Statistic::Kind::percentile && (of->in_every_use || name.of_worst_use);
  if (name.of_worst_use) out.name.insert(0, worst_prefix);
  return out;
}

std::optional<double> percentile(const std::vector<std::optional<double>>& values, double percent) {
  const double missing = percent < 50.0 ? -HUGE_VAL : HUGE_VAL;
  std::vector<double> sorted;
  for (const std::optional<double>& value : values) sorted.push_back(value.value_or(missing));
  std::ranges::sort(sorted);
  const double last = static_cast<double>(sorted.size() - 1);
  const double place = std::clamp(0.01 * percent * (last + 1.0) - 0.5, 0.0, last);
  const auto below = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(below);
  double out = sorted[below];
  if (share > 0.0) out += share * (sorted[below + 1] - out);
  return std::isfinite(out) ? std::optional(out) : std::nullopt;
}

SpreadQuantities::SpreadQuantities(Spread spread)
    : spread_(std::make_shared<const Spread>(std::move(spread))),
      asked_(std::make_shared<std::vector<AskedOfBuild>>()),
      values_([spread = spread_, asked = asked_](const simulation::DesignView& design) {
        return values_of_builds(*spread, *asked, design);
      }) {}

std::optional<simulation::ResultQuantity> SpreadQuantities::find(std::string_view name,
                                                                 const simulation::QuantityTable& known) {
  const std::optional<StatisticName> parts = statistic_named(name);
  std::optional<simulation::ResultQuantity> of = parts ? quantity_of(*parts, known) : std::nullopt;
  if (!of) return std::nullopt;
  const AskedOfBuild asked{.quantity = *of, .high_is_worse = !counts_low_values(parts->statistic)};
  const auto is_same = [&asked](const AskedOfBuild& other) {
    return other.quantity.name == asked.quantity.name && other.in_every_use() == asked.in_every_use() &&
           other.high_is_worse == asked.high_is_worse;
  };
  const auto place = std::ranges::find_if(*asked_, is_same);
  const auto index = static_cast<std::size_t>(place - asked_->begin());
  if (place == asked_->end()) asked_->push_back(asked);
  simulation::ResultQuantity out = *std::move(of);
  out.name = std::string(name);
  out.meaning = fmt::format(
      "{}: {}", meaning_of(parts->statistic, spread_->draws, out.in_every_use && has_uses(*spread_)), out.meaning);
  out.value = [values = values_, index, statistic = parts->statistic](const simulation::DesignView& design) {
    return value_of(statistic, (*values.of(design))[index]);
  };
  out.value_of_lumped = {};
  out.absence = "it has none in too many builds of the spread";
  out.why_absent = {};
  out.in_every_use = false;  // that it is, the statistic itself says
  return out;
}

}  // namespace coilwright::sizing
