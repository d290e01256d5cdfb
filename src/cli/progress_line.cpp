#include "cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "coilwright/text/one_line.hpp"
#include "coilwright/text/output/plain_output.hpp"

namespace coilwright::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto memory = 30s;

}  // namespace

void Pace::learn(Time now, std::size_t done) {
  moments_.emplace_back(now, done);
  // The last moment before that time stays: the time between it and now is then the whole memory.
  while (moments_.size() > 2 && moments_[1].first <= now - memory) moments_.pop_front();
}

std::optional<double> Pace::rate() const {
  if (moments_.size() < 2) return std::nullopt;
  const std::chrono::duration<double> time = moments_.back().first - moments_.front().first;
  const auto done = static_cast<double>(moments_.back().second - moments_.front().second);
  if (!(time.count() > 0.0) || !(done > 0.0)) return std::nullopt;
  return done / time.count();
}

std::optional<double> Pace::left(std::size_t all) const {
  const std::optional<double> designs_per_second = rate();
  if (!designs_per_second) return std::nullopt;
  const std::size_t done = std::min(moments_.back().second, all);
  return static_cast<double>(all - done) / *designs_per_second;
}

std::string duration_text(double seconds) {
  constexpr long minute = 60, hour = 3600;
  const long whole = std::lround(std::min(seconds, 1e9));
  if (whole < minute) return fmt::format("{} s", whole);
  if (whole < hour) return fmt::format("{} min {} s", whole / minute, whole % minute);
  return fmt::format("{} h {} min", whole / hour, whole % hour / minute);
}

ProgressLine::ProgressLine(std::ostream& out, Place place, std::chrono::milliseconds interval,
                           std::function<std::string()> words)
    : out_(text::PlainOutput::past(out)), place_(place), interval_(interval), words_(std::move(words)) {
  if (place_ != Place::nowhere) thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

ProgressLine::~ProgressLine() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  if (length_ > 0) out_ << '\r' << std::string(length_, ' ') << '\r' << std::flush;
}

void ProgressLine::work(const std::stop_token& stop) {
  std::unique_lock lock(guard_);
  if (place_ == Place::log) over_.wait_for(lock, stop, interval_, [] { return false; });
  while (!stop.stop_requested()) {
    const std::string text = text::one_line(words_(), 1000);
    if (place_ == Place::log) {
      out_ << text + '\n' << std::flush;
    } else {
      const std::size_t rest = length_ > text.size() ? length_ - text.size() : 0;
      out_ << '\r' + text + std::string(rest, ' ') << std::flush;
      length_ = std::max(length_, text.size());
    }
    over_.wait_for(lock, stop, interval_, [] { return false; });
  }
}

ProgressLine::Place progress_place(bool quiet) {
  if (quiet) return ProgressLine::Place::nowhere;
  return isatty(STDERR_FILENO) == 1 ? ProgressLine::Place::terminal : ProgressLine::Place::log;
}

std::chrono::milliseconds progress_interval(ProgressLine::Place place) {
  return place == ProgressLine::Place::log ? 30s : 100ms;
}

}  // namespace coilwright::cli
