#include "measurement/fit/parallel.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace coilwright::measurement::fit {

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& task) {
  tbb::task_group_context loop;
  tbb::parallel_for(std::size_t{0}, count, task, loop);
  // An exception of a task ends the loops in all tasks beside it, and theirs, without a word.
  if (loop.is_group_execution_cancelled()) throw GivenUp();
}

void with_threads(int threads, const std::function<void()>& task) {
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute(task);
}

}  // namespace coilwright::measurement::fit
