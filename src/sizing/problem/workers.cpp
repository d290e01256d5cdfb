#include "sizing/problem/workers.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <exception>
#include <optional>

namespace coilwright::sizing {

struct Workers::Arena {
  explicit Arena(unsigned threads) : arena{threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads)} {
    // By default TBB runs no more threads than there are cores.
    const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    if (threads > allowed) more.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

  std::optional<tbb::global_control> more;
  tbb::task_arena arena;
};

Workers::Workers(unsigned threads) : arena_{std::make_unique<Arena>(threads)} {}

Workers::~Workers() = default;

void Workers::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::vector<std::exception_ptr> thrown(count);
  arena_->arena.execute([&] {
    // simple_partitioner and a grain of 1, because tasks are few and of very different length.
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>{0, count, 1},
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            try {
              // Isolated: a task that waits for a TBB loop inside must not take over another task, which might wait
              // for the design that this very thread is evaluating.
              tbb::this_task_arena::isolate([&] { task(i); });
            } catch (...) {
              thrown[i] = std::current_exception();
            }
          }
        },
        tbb::simple_partitioner{});
  });
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
}

std::vector<Record> Workers::evaluate(Archive& archive, const std::vector<std::vector<double>>& points,
                                      const std::stop_token& stop,
                                      const std::function<std::string_view(std::size_t i)>& proposed_by) {
  if (archive.problem().evaluate_together && !stop.stop_requested()) archive.evaluate_together(points);
  std::vector<std::optional<Evaluation>> evaluations(points.size());
  run(points.size(), [&](std::size_t i) {
    if (!stop.stop_requested()) evaluations[i] = archive.evaluate(points[i]);
  });
  std::vector<Record> records;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!evaluations[i]) continue;
    archive.number(points[i], proposed_by ? proposed_by(i) : std::string_view());
    records.push_back({.point = points[i], .evaluation = std::move(*evaluations[i])});
  }
  return records;
}

}  // namespace coilwright::sizing
