#pragma once

#include <cstddef>
#include <exception>
#include <functional>

namespace coilwright::measurement::fit {

/// A loop was given up because a task beside it threw: what it should have made is not there. It never leaves
/// with_threads(): what is thrown there is what the other task threw.
class GivenUp : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "given up because of another failure"; }
};

/// Calls `task(i)` for every i below `count`, in any order on the threads of with_threads(), and returns when all calls
/// have ended. Throws what a call throws. Loops inside of the others then end early, and throw GivenUp: a fit whose
/// runs were not all simulated must not be taken for one that has no motion.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& task);

/// Calls `task`, whose loops run on so many threads; 0: one per core. Throws what it throws.
void with_threads(int threads, const std::function<void()>& task);

}  // namespace coilwright::measurement::fit
