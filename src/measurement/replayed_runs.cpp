#include "coilwright/measurement/replayed_runs.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "measurement/data/usable_runs.hpp"
#include "measurement/final_errors.hpp"
#include "measurement/replayed_channels.hpp"

namespace coilwright::measurement {
namespace {

identification::FittedHypothesis with_declared_numbers(const replay::DeclaredModel& model, double model_error) {
  const fit::Hypothesis hypothesis(model, {});
  return {.hypothesis = hypothesis, .fit = {.values = hypothesis.start(), .model_error = model_error}};
}

// Leaves out of a run what is listed of it, and nothing else.
void set_aside_as(std::span<const Outliers> listed, bool validate, replay::PreparedRun& prepared) {
  const data::Run& run = *prepared.run;
  prepared.set_aside.assign(run.channels.size(), {});
  for (const Outliers& each : listed) {
    const auto channel = std::ranges::find(run.channels, each.channel, &data::Channel::name);
    if (each.run != run.name || each.validate != validate || channel == run.channels.end()) continue;
    std::vector<char>& aside = prepared.set_aside[static_cast<std::size_t>(channel - run.channels.begin())];
    for (const double time : run.times) aside.push_back(std::ranges::count(each.times, time) != 0 ? 1 : 0);
  }
}

}  // namespace

struct ReplayedRuns::Prepared {
  data::SealedRuns fit, validate;  // the prepared runs refer to these
  std::vector<replay::PreparedRun> runs{};
  int coils{}, joints{};  // of the model that they are prepared for
};

ReplayedRuns::ReplayedRuns(data::Dataset data, const replay::DeclaredModel& found, const Known& known) {
  auto prepared = std::make_unique<Prepared>(
      Prepared{.fit = data::SealedRuns(data::usable_runs(data.fit).runs), .validate = std::move(data.validate)});
  const identification::FittedHypothesis model = with_declared_numbers(found, known.model_error);
  const actuator::Model nominal = model.hypothesis.model_at(model.fit.values);
  prepared->coils = nominal.coils();
  prepared->joints = nominal.joints();
  for (const data::SealedRuns* runs : {&prepared->fit, &prepared->validate})
    for (replay::PreparedRun& run : FinalErrors::prepared(*runs, found, nominal, model, data.still)) {
      const bool validate = runs == &prepared->validate;
      set_aside_as(known.outliers, validate, run);
      std::vector<Replay>& channels = channels_.emplace_back();
      for (std::size_t c = 0; c < run.run->channels.size(); ++c) channels.push_back(measured_channel(run, c, validate));
      prepared->runs.push_back(std::move(run));
    }
  prepared_ = std::move(prepared);
}

ReplayedRuns::~ReplayedRuns() = default;
ReplayedRuns::ReplayedRuns(ReplayedRuns&&) noexcept = default;

std::size_t ReplayedRuns::size() const noexcept {
  return channels_.size();
}

const std::vector<Replay>& ReplayedRuns::channels(std::size_t run) const {
  return channels_[run];
}

std::optional<std::vector<std::vector<double>>> ReplayedRuns::shown_of(std::size_t run,
                                                                       const replay::DeclaredModel& model) const {
  const identification::FittedHypothesis asked = with_declared_numbers(model, 1.0);
  const actuator::Model built = asked.hypothesis.model_at(asked.fit.values);
  const replay::PreparedRun& prepared = prepared_->runs[run];
  if (prepared.run->drive != data::Drive::voltage && built.coils() == prepared_->coils &&
      built.joints() == prepared_->joints)
    return measurement::shown_of(prepared, asked);
  // Its input is currents of coils and torques of joints.
  replay::PreparedRun anew = prepared;
  anew.windows = replay::prepare_run(*prepared.run, model, built).windows;
  for (std::size_t i = 0; i < anew.windows.size(); ++i)
    anew.windows[i].input_whitener = prepared.windows[i].input_whitener;
  return measurement::shown_of(anew, asked);
}

}  // namespace coilwright::measurement
