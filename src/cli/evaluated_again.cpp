#include "evaluated_again.hpp"

#include <stdexcept>

namespace coilwright::cli {

sizing::DesignResult evaluated_again(const sizing::DesignProblem& problem, std::span<const double> point,
                                     const sizing::Evaluation& found) {
  sizing::DesignResult result = problem.evaluate(point);
  if (problem.assess(result) != found || !sizing::is_feasible(found))
    throw std::logic_error("a design that the search found gives other numbers when it is evaluated again");
  return result;
}

}  // namespace coilwright::cli
