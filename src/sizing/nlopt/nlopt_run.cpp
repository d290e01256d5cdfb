#include "sizing/nlopt/nlopt_run.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <new>

namespace coilwright::sizing {
namespace {

nlopt_algorithm nlopt_name(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::cobyla:
      return NLOPT_LN_COBYLA;
    case Algorithm::bobyqa:
      return NLOPT_LN_BOBYQA;
    case Algorithm::sbplx:
      return NLOPT_LN_SBPLX;
    case Algorithm::neldermead:
      return NLOPT_LN_NELDERMEAD;
    case Algorithm::slsqp:
      return NLOPT_LD_SLSQP;
    case Algorithm::mma:
      return NLOPT_LD_MMA;
    case Algorithm::isres:
      return NLOPT_GN_ISRES;
    case Algorithm::crs2:
      return NLOPT_GN_CRS2_LM;
    case Algorithm::esch:
      return NLOPT_GN_ESCH;
    case Algorithm::direct_l:
      return NLOPT_GN_DIRECT_L;
    case Algorithm::automatic:
      break;
  }
  assert(false && "automatic is not an NLopt algorithm");
  return NLOPT_NUM_ALGORITHMS;
}

struct OptDeleter {
  void operator()(nlopt_opt opt) const noexcept { nlopt_destroy(opt); }
};
using Opt = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, OptDeleter>;

// State of the C callbacks. Once a run is to end they return a finite worst value without a call.
struct Session {
  const NloptTask* task;
  nlopt_opt opt;
  std::exception_ptr thrown;

  template <typename Call>
  bool guarded(std::span<const double> x, Call&& call) noexcept {
    if (thrown) return false;
    // SLSQP steps to NaN where differences across a cliff make its least squares singular: the run ends there.
    if (!std::ranges::all_of(x, [](double value) { return std::isfinite(value); })) {
      nlopt_force_stop(opt);
      return false;
    }
    try {
      call();
      return true;
    } catch (...) {
      thrown = std::current_exception();
      nlopt_force_stop(opt);
      return false;
    }
  }
};

// NLopt says so, and would go another way.
void require_memory(nlopt_result result) {
  if (result == NLOPT_OUT_OF_MEMORY) throw std::bad_alloc{};
}

constexpr double worst = 1e30;  // only ever seen by NLopt, until it notices the forced stop

double objective_callback(unsigned n, const double* x, double* gradient, void* data) noexcept {
  auto& session = *static_cast<Session*>(data);
  double value = worst;
  const auto call = [&] {
    value = session.task->objective({x, n}, gradient ? std::span<double>{gradient, n} : std::span<double>{});
  };
  if (!session.guarded({x, n}, call) && gradient) std::fill_n(gradient, n, 0.0);
  return value;
}

void constraint_callback(unsigned m, double* values, unsigned n, const double* x, double* jacobian,
                         void* data) noexcept {
  auto& session = *static_cast<Session*>(data);
  const std::size_t entries = std::size_t{m} * n;
  const auto call = [&] {
    session.task->constraints({x, n}, {values, m},
                              jacobian ? std::span<double>{jacobian, entries} : std::span<double>{});
  };
  if (session.guarded({x, n}, call)) return;
  std::fill_n(values, m, worst);
  if (jacobian) std::fill_n(jacobian, entries, 0.0);
}

}  // namespace

bool takes_constraints(Algorithm algorithm) {
  return algorithm == Algorithm::cobyla || algorithm == Algorithm::slsqp || algorithm == Algorithm::mma ||
         algorithm == Algorithm::isres;
}

bool takes_gradients(Algorithm algorithm) {
  return algorithm == Algorithm::slsqp || algorithm == Algorithm::mma;
}

bool is_global(Algorithm algorithm) {
  return algorithm == Algorithm::isres || algorithm == Algorithm::crs2 || algorithm == Algorithm::esch ||
         algorithm == Algorithm::direct_l;
}

std::vector<double> run_nlopt(const NloptTask& task) {
  const std::size_t n = task.start.size();
  const Opt opt{nlopt_create(nlopt_name(task.algorithm), static_cast<unsigned>(n))};
  if (!opt) throw std::bad_alloc{};
  Session session{.task = &task, .opt = opt.get(), .thrown = nullptr};
  nlopt_srand(task.seed);
  nlopt_set_min_objective(opt.get(), objective_callback, &session);
  nlopt_set_lower_bounds(opt.get(), task.lower.data());
  nlopt_set_upper_bounds(opt.get(), task.upper.data());
  if (task.constraint_count > 0) {
    const std::vector<double> tolerance(task.constraint_count, 0.0);
    require_memory(nlopt_add_inequality_mconstraint(opt.get(), static_cast<unsigned>(task.constraint_count),
                                                    constraint_callback, &session, tolerance.data()));
  }
  nlopt_set_maxeval(opt.get(), task.max_calls);
  if (task.relative_tolerance > 0) nlopt_set_xtol_rel(opt.get(), task.relative_tolerance);
  if (task.first_step > 0) require_memory(nlopt_set_initial_step1(opt.get(), task.first_step));
  std::vector<double> x = task.start;
  for (std::size_t i = 0; i < n; ++i) x[i] = std::clamp(x[i], task.lower[i], task.upper[i]);
  std::vector<double> start = x;
  double value = 0;
  require_memory(nlopt_optimize(opt.get(), x.data(), &value));
  if (session.thrown) std::rethrow_exception(session.thrown);
  if (!std::ranges::all_of(x, [](double v) { return std::isfinite(v); })) return start;
  return x;
}

}  // namespace coilwright::sizing
