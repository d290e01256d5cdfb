#include "mechanics/lemke.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace coilwright::mechanics {
namespace {

// basic variables = first column + tableau * the others, which are zero. Variables are numbered w, z, covering.
class Tableau {
 public:
  void set(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& constant, const LemkeTolerances& tolerances) {
    size_ = static_cast<int>(constant.size());
    tolerances_ = tolerances;
    rows_.resize(size_, size_ + 2);
    rows_.col(0) = constant;
    rows_.middleCols(1, size_) = matrix;
    rows_.col(size_ + 1).setOnes();
    basic_.resize(static_cast<std::size_t>(size_));
    others_.resize(static_cast<std::size_t>(size_) + 2);
    std::iota(basic_.begin(), basic_.end(), 0);
    others_.front() = -1;
    std::iota(others_.begin() + 1, others_.end(), size_);
  }

  [[nodiscard]] int covering() const { return 2 * size_; }
  [[nodiscard]] int basic(int row) const { return basic_[row]; }

  // The row that the covering variable replaces first: the smallest constant; of equal ones the last, whose
  // perturbation is smallest.
  [[nodiscard]] int first_row() const {
    int row = 0;
    for (int i = 1; i < size_; ++i)
      if (rows_(i, 0) <= rows_(row, 0)) row = i;
    return row;
  }

  [[nodiscard]] int column_of(int variable) const {
    int column = 1;
    while (others_[column] != variable) ++column;
    return column;
  }

  // The row whose basic variable is the first to reach zero as that of the column grows; -1: none does.
  [[nodiscard]] int blocking_row(int column) const {
    int row = -1;
    for (int i = 0; i < size_; ++i)
      if (rows_(i, column) < -tolerances_.pivot && (row < 0 || blocks_earlier(i, row, column))) row = i;
    return row;
  }

  void exchange(int row, int column) {
    const double pivot = rows_(row, column);
    rows_.row(row) /= -pivot;
    rows_(row, column) = 1.0 / pivot;
    for (int i = 0; i < size_; ++i) {
      const double factor = rows_(i, column);
      if (i == row || factor == 0.0) continue;
      rows_(i, column) = 0.0;
      rows_.row(i) += factor * rows_.row(row);
    }
    std::swap(basic_[row], others_[column]);
  }

  [[nodiscard]] Eigen::VectorXd solution() const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(size_);
    for (int i = 0; i < size_; ++i)
      if (basic_[i] >= size_ && basic_[i] < covering()) z[basic_[i] - size_] = std::max(0.0, rows_(i, 0));
    return z;
  }

 private:
  // Share of the k-th perturbation of the constants in a row.
  [[nodiscard]] double perturbation(int row, int k) const {
    for (int column = 1; column <= size_ + 1; ++column)
      if (others_[column] == k) return -rows_(row, column);
    return basic_[row] == k ? 1.0 : 0.0;
  }

  [[nodiscard]] bool blocks_earlier(int a, int b, int column) const {
    const double slope_a = -rows_(a, column);
    const double slope_b = -rows_(b, column);
    double of_a = rows_(a, 0) / slope_a;
    double of_b = rows_(b, 0) / slope_b;
    if (std::abs(of_a - of_b) > tolerances_.tie * (1.0 + std::abs(of_a) + std::abs(of_b))) return of_a < of_b;
    if (basic_[a] == covering() || basic_[b] == covering()) return basic_[a] == covering();
    for (int k = 0; k < size_; ++k) {
      of_a = perturbation(a, k) / slope_a;
      of_b = perturbation(b, k) / slope_b;
      if (std::abs(of_a - of_b) > 1e-9 * (std::abs(of_a) + std::abs(of_b))) return of_a < of_b;
    }
    return a < b;
  }

  int size_{};
  LemkeTolerances tolerances_{};
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows_;
  std::vector<int> basic_;
  std::vector<int> others_;  // by column; the first column is the constant
};

}  // namespace

std::optional<Eigen::VectorXd> lemke(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& constant,
                                     const LemkeTolerances& tolerances) {
  const int size = static_cast<int>(constant.size());
  if (size == 0 || constant.minCoeff() >= 0.0) return Eigen::VectorXd::Zero(size);
  // Kept from call to call for its memory alone: a step of a robot solves one of the size of the step before.
  thread_local Tableau tableau;
  tableau.set(matrix, constant, tolerances);
  int row = tableau.first_row();
  int column = size + 1;
  // Paths are about two exchanges a variable long; random problems of 24 variables took 63 at most.
  for (int k = 0; k < 50 * size; ++k) {
    const int leaving = tableau.basic(row);
    tableau.exchange(row, column);
    if (leaving == tableau.covering()) return tableau.solution();
    column = tableau.column_of(leaving < size ? leaving + size : leaving - size);
    row = tableau.blocking_row(column);
    if (row < 0) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace coilwright::mechanics
