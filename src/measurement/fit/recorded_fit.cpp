#include "measurement/fit/recorded_fit.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/measurement/replay/known_fits.hpp"
#include "measurement/fit/fit.hpp"
#include "measurement/fit/residual_place.hpp"

namespace coilwright::measurement::fit {
namespace {

// As they are in memory, behind their count: no two sequences of lists have the same bytes.
void add(std::string& out, std::span<const double> numbers) {
  const auto count = static_cast<double>(numbers.size());
  out.append(reinterpret_cast<const char*>(&count), sizeof count);
  out.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
}
void add(std::string& out, const Eigen::VectorXd& numbers) {
  add(out, std::span(numbers.data(), static_cast<std::size_t>(numbers.size())));
}
void add(std::string& out, std::string_view name) {
  out.append(name).push_back('\0');
}

// A nameless correction is a kind of its own each time: the torques of unequal coefficients tell which.
void add_correction(std::string& out, const Hypothesis& hypothesis, const actuator::Effect& effect) {
  if (effect.values.empty() || !effect.kind->parameters().front().deviation) return;
  std::vector<double> unequal(effect.values.size());
  std::iota(unequal.begin(), unequal.end(), 1.0);
  actuator::ModelSpec spec = hypothesis.declared().build(hypothesis.calibration_in(hypothesis.start()));
  static_cast<void>(effect.kind->build(unequal, spec));
  if (!spec.torque_correction) return;
  for (const actuator::CorrectionAxis& axis : spec.torque_correction->axes) {
    add(out, name_of(axis.variable));
    add(out, axis.nodes);
  }
  add(out, spec.torque_correction->torques);
}

void add_hypothesis(std::string& out, const Hypothesis& hypothesis) {
  for (const FitParameter& each : hypothesis.parameters()) {
    add(out, each.key);
    add(out, std::vector{each.lower, each.upper, each.scale, each.declared, each.tolerance, each.farthest});
  }
  for (const actuator::Effect& effect : hypothesis.effects()) {
    add(out, effect.kind->id());
    for (const actuator::EffectParameter& number : effect.kind->parameters()) add(out, number.key);
    add(out, effect.values);
    add_correction(out, hypothesis, effect);
  }
}

// What a block is of: its samples, and what noise, outliers and priors make of them, which is all in the residuals of a
// model that predicts nothing.
void add_block(std::string& out, const FitRequest& request, const ResidualBlock& block) {
  const replay::PreparedRun& prepared = request.runs[block.run];
  const replay::SampleRange range = prepared.sample_ranges()[block.window];
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(prepared.values_in(range));
  const std::vector<double> zero(block.local.size(), 0.0);
  add(out, prepared.run->name);
  add(out, std::vector{static_cast<double>(range.first), static_cast<double>(range.last)});
  add(out, residuals_with_prior(block, prepared, range, nothing, zero));
  add(out, block.numbers.sigma());
  add(out, block.local);
}

// Those of another fit that this one takes over.
void add_derivatives(std::string& out, const FitRequest& request, std::span<const ResidualBlock> blocks) {
  const Fit& known = *request.derivatives_from;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (Eigen::Index i = 0; i < request.hypothesis->size(); ++i)
      if (request.hypothesis->is_nominal(i)) add(out, Eigen::VectorXd(known.parameter_columns[b].col(i)));
    for (std::size_t i = 0; i < blocks[b].local.size(); ++i) {
      if (!blocks[b].numbers.moves(i)) continue;
      add(out, Eigen::VectorXd(known.local_columns[b].col(static_cast<Eigen::Index>(i))));
      add(out, std::vector{known.runs[blocks[b].run].local_numbers[blocks[b].window][i]});
    }
  }
}

std::string question_of(const FitRequest& request, std::span<const ResidualBlock> blocks, Unknowns unknowns) {
  std::string out;
  add(out, std::vector{static_cast<double>(unknowns), static_cast<double>(request.effort.iterations),
                       request.effort.tolerance, request.updates_derivatives ? 1.0 : 0.0,
                       static_cast<double>(request.held_parameter.value_or(-1)),
                       request.local_numbers_from != nullptr ? 1.0 : 0.0, replay::model_error_of(request.runs)});
  add(out, request.start);
  add_hypothesis(out, *request.hypothesis);
  for (const ResidualBlock& block : blocks) add_block(out, request, block);
  if (request.derivatives_from != nullptr) add_derivatives(out, request, blocks);
  return out;
}

// All numbers of an optimum, in one order; `use` takes them list by list.
template <class Use>
void each_list(Optimum& optimum, std::span<double> local_numbers, Use use) {
  const auto use_all = [&](auto& matrix) { use(std::span(matrix.data(), static_cast<std::size_t>(matrix.size()))); };
  use(local_numbers);
  use_all(optimum.parameters);
  for (ResidualValues::Block& block : optimum.values.blocks) {
    use_all(block.residuals);
    use_all(block.jacobian);
    use_all(block.local_jacobian);
  }
  for (Eigen::VectorXd& predictions : optimum.values.predictions) use_all(predictions);
}

// Of the right sizes.
Optimum blank(const FitRequest& request, std::span<const ResidualBlock> blocks) {
  const Eigen::Index p = request.hypothesis->size();
  Optimum out{.parameters = Eigen::VectorXd(p), .values = {}};
  for (const ResidualBlock& block : blocks)
    out.values.blocks.push_back(
        {.residuals = Eigen::VectorXd(block.rows),
         .jacobian = Eigen::MatrixXd(block.rows, p),
         .local_jacobian = Eigen::MatrixXd(block.rows, static_cast<Eigen::Index>(block.local.size()))});
  for (const replay::PreparedRun& run : request.runs) out.values.predictions.emplace_back(run.values());
  return out;
}

// Whether a fit that was recorded is one of this request: evaluated again where it ended, it has the same numbers.
// Derivatives that were carried along the way of the fit come out of that way only.
bool comes_out_again(const FitRequest& request, ResidualBlocks& blocks, Unknowns unknowns, const Optimum& found) {
  const Derivatives derivatives = request.updates_derivatives           ? Derivatives::none
                                  : unknowns == Unknowns::local_numbers ? Derivatives::by_local_numbers
                                                                        : Derivatives::all;
  if (found.parameters != request.hypothesis->clamped(found.parameters)) return false;
  const std::optional<ResidualValues> again = blocks.evaluate(found.parameters, derivatives);
  if (!again || again->predictions != found.values.predictions) return false;
  return std::ranges::equal(again->blocks, found.values.blocks, [&](const auto& a, const auto& b) {
    return a.residuals == b.residuals &&
           (derivatives == Derivatives::none || (a.jacobian == b.jacobian && a.local_jacobian == b.local_jacobian));
  });
}

}  // namespace

std::optional<Optimum> recorded_or(const FitRequest& request, ResidualBlocks& blocks, Unknowns unknowns,
                                   const std::function<std::optional<Optimum>()>& made) {
  const replay::KnownFits* known = request.runs.empty() ? nullptr : request.runs.front().known_fits.get();
  if (known == nullptr) return made();
  const std::string asked = question_of(request, blocks.blocks(), unknowns);
  if (const std::optional<std::string> found = known->recall(asked)) {
    Optimum out = blank(request, blocks.blocks());
    ResidualBlocks again(request);
    std::string_view rest = *found;
    bool whole = true;
    each_list(out, again.local_numbers(), [&](std::span<double> list) {
      whole = whole && rest.size() >= list.size_bytes();
      if (!whole || list.empty()) return;  // of none, its data may be null
      std::memcpy(list.data(), rest.data(), list.size_bytes());
      rest.remove_prefix(list.size_bytes());
    });
    if (whole && rest.empty() && comes_out_again(request, again, unknowns, out)) {
      std::ranges::copy(again.local_numbers(), blocks.local_numbers().begin());
      return out;
    }
    if (known->differs) known->differs();
  }
  std::optional<Optimum> optimum = made();
  if (!optimum) return std::nullopt;  // which is soon found again
  std::string found;
  each_list(*optimum, blocks.local_numbers(), [&](std::span<double> list) {
    found.append(reinterpret_cast<const char*>(list.data()), list.size_bytes());
  });
  known->keep(asked, found);
  return optimum;
}

}  // namespace coilwright::measurement::fit
