#include "control/profile_search.hpp"

#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>

#include "coilwright/control/arrival.hpp"

namespace coilwright::control {
namespace {

// Shorter pieces are left out: a simulation would stop for them and a driver skip them.
constexpr double shortest_piece = 0.1e-3;  // s

constexpr int calls_a_number = 60;
constexpr double worst_of_all = 1e3;  // s; of a motion that cannot be followed

// Levels, then lengths, each from 0 to 1.
using Point = std::vector<double>;

class Profiles {
 public:
  Profiles(const std::vector<actuator::Model>& models, const ProfileSearch& search)
      : models_(models), search_(search), best_(step()), best_value_(value_of(best_)) {}

  [[nodiscard]] int numbers() const { return 2 * search_.pieces; }

  [[nodiscard]] CurrentProfile profile_at(const Point& point) const {
    CurrentProfile out{.before = search_.start_current};
    double time = 0.0;
    for (int i = 0; i < search_.pieces; ++i) {
      const double length = search_.longest_piece * point[search_.pieces + i];
      if (length < shortest_piece) continue;
      out.times.push_back(time);
      out.levels.push_back(search_.lowest + (search_.highest - search_.lowest) * point[i]);
      time += length;
    }
    out.times.push_back(time);
    out.levels.push_back(search_.current);
    return out;
  }

  // Pieces that a start has too many are left out at its end, those it has too few have no length.
  [[nodiscard]] Point point_of(const CurrentProfile& start) const {
    Point point(static_cast<std::size_t>(numbers()), 0.0);
    for (int i = 0; i < search_.pieces; ++i) {
      const bool there = i + 1 < static_cast<int>(start.levels.size());
      const double level = there ? start.levels[i] : search_.current;
      const double length = there ? start.times[i + 1] - start.times[i] : 0.0;
      point[i] = std::clamp((level - search_.lowest) / (search_.highest - search_.lowest), 0.0, 1.0);
      point[search_.pieces + i] = std::clamp(length / search_.longest_piece, 0.0, 1.0);
    }
    return point;
  }

  double value(const Point& point) {
    const CurrentProfile profile = profile_at(point);
    const double value = value_of(profile);
    if (value < best_value_) {
      best_value_ = value;
      best_ = profile;
    }
    return value;
  }

  [[nodiscard]] const CurrentProfile& best() const { return best_; }

 private:
  [[nodiscard]] CurrentProfile step() const {
    return {.before = search_.start_current, .times = {0.0}, .levels = {search_.current}};
  }

  [[nodiscard]] double value_of(const CurrentProfile& profile) const {
    if (profile.times.back() >= search_.duration) return worst_of_all;
    double worst = 0.0;
    try {
      for (const actuator::Model& model : models_) {
        const Arrival one = arrival(model, profile, search_.duration);
        const double beyond = std::max(0.0, one.overshoot - most_overshoot);
        worst = std::max(worst, one.time_outside + beyond * search_.duration);
      }
    } catch (const std::runtime_error&) {
      return worst_of_all;  // it cannot be followed, or ends in another pose
    }
    return worst;
  }

  const std::vector<actuator::Model>& models_;
  const ProfileSearch& search_;
  CurrentProfile best_;
  double best_value_;
};

// What NLopt, a C library, hands to the objective: no exception may pass through it.
struct Session {
  Profiles& profiles;
  nlopt_opt optimiser;
  std::exception_ptr thrown;
};

double nlopt_value(unsigned count, const double* x, double*, void* data) {
  auto& session = *static_cast<Session*>(data);
  try {
    return session.profiles.value(Point(x, x + count));
  } catch (...) {
    session.thrown = std::current_exception();
    nlopt_force_stop(session.optimiser);
    return worst_of_all;
  }
}

void minimise(Profiles& profiles, Point start) {
  const auto numbers = static_cast<unsigned>(profiles.numbers());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(nlopt_create(NLOPT_LN_SBPLX, numbers),
                                                                         &nlopt_destroy);
  if (!optimiser) throw std::bad_alloc{};
  Session session{.profiles = profiles, .optimiser = optimiser.get(), .thrown = nullptr};
  nlopt_set_lower_bounds1(optimiser.get(), 0.0);
  nlopt_set_upper_bounds1(optimiser.get(), 1.0);
  nlopt_set_initial_step1(optimiser.get(), 0.1);
  nlopt_set_min_objective(optimiser.get(), nlopt_value, &session);
  nlopt_set_maxeval(optimiser.get(), calls_a_number * profiles.numbers());
  nlopt_set_xtol_abs1(optimiser.get(), 1e-4);
  double least{};
  // Profiles keeps the best point; where NLopt's own rounding stops it, that is as good an end as any other.
  if (nlopt_optimize(optimiser.get(), start.data(), &least) == NLOPT_OUT_OF_MEMORY) throw std::bad_alloc{};
  if (session.thrown) std::rethrow_exception(session.thrown);
}

}  // namespace

CurrentProfile search_profile(const std::vector<actuator::Model>& models, const ProfileSearch& search) {
  Profiles profiles(models, search);
  std::vector<Point> starts;
  for (const CurrentProfile& each : search.starts) starts.push_back(profiles.point_of(each));
  // A push as hard as the driver can, a brake, and the hold.
  const bool forwards = search.current >= search.start_current;
  starts.push_back(profiles.point_of({.before = search.start_current,
                                      .times = {0.0, 0.25 * search.longest_piece, 0.5 * search.longest_piece},
                                      .levels = {forwards ? search.highest : search.lowest,
                                                 forwards ? search.lowest : search.highest, search.current}}));
  for (const Point& start : starts) minimise(profiles, start);
  return profiles.best();
}

}  // namespace coilwright::control
