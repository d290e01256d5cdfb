#pragma once

#include <vector>

#include <Eigen/Sparse>

#include "coilwright/thermal/chain.hpp"

namespace coilwright::thermal {

/// Heat in an actuator by finite volumes in three dimensions, as a second route to the network: half of the body in
/// Cartesian cells of silicone, each coil as rings (a turn is copper all around, so it has one temperature) in layers,
/// each magnet at one temperature. Paths, jackets, fins and hot spots of the network are not in it; the film on the
/// outside and on open faces is the same.
class FiniteVolumes {
 public:
  /// `cell`: side of a cell across the body, m.
  FiniteVolumes(const HeatChain& chain, double cell);

  /// What the coils reach, degC: mean and hottest place of the hottest coil, and the hottest magnet.
  struct Temperatures {
    double mean{};
    double hot_spot{};
    double magnet{};
  };
  /// Steady state under one mean square current (A^2) in every coil.
  [[nodiscard]] Temperatures steady(double mean_square) const;
  /// Current (A) whose steady hot spot is at `limit` (degC).
  [[nodiscard]] double continuous_current(double limit) const;
  /// Time (s) from ambient temperature until a hot spot is at `limit` under `current` (A), by steps of `step` (s).
  [[nodiscard]] double time_to_limit(double current, double limit, double step) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  struct Layer {
    std::size_t segment{};
    bool core{};      // through the coil or magnet
    bool last{};      // of its segment: a joint follows, or the end
    double length{};  // m
  };
  struct Heated {
    int unknown{};
    std::size_t segment{};
    double share{};  // of its coil's section and length
  };

  void cut_layers();
  void number_unknowns();
  void join_across(std::size_t layer);
  void join_along(std::size_t layer);
  void join_faces(std::size_t layer, int first, int second, double area, double open, double distance);
  void fill_cores();
  void link(int first, int second, double conductance);
  void to_ambient(int unknown, double conductance) { diagonal_[static_cast<std::size_t>(unknown)] += conductance; }
  [[nodiscard]] int& at(std::size_t layer, int x, int y);
  [[nodiscard]] bool in_core(std::size_t layer, int x, int y) const;
  [[nodiscard]] double radius_at(int x, int y) const;
  [[nodiscard]] double half_path(std::size_t layer, int x, int y) const;  // to a layer's end face, m2 K/W
  [[nodiscard]] Matrix matrix(double mean_square, double per_time) const;
  [[nodiscard]] Eigen::VectorXd heat(double mean_square) const;
  [[nodiscard]] Temperatures read(const Eigen::VectorXd& rises) const;
  int add(double capacity);

  HeatChain chain_;
  int nx_{}, ny_{};
  double dx_{}, dy_{};
  std::vector<Layer> layers_;
  std::vector<int> grid_;
  std::vector<double> diagonal_;
  std::vector<double> capacity_;
  std::vector<Eigen::Triplet<double>> links_;
  std::vector<Heated> heated_;
  std::vector<int> magnets_;
};

}  // namespace coilwright::thermal
