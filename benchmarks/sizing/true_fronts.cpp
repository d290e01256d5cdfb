// Recomputes tests/data/sizing/front_problems.csv: ideal, nadir and hypervolume of each problem's true front, by ways
// that share nothing with the search: curves known in closed form, sums of separable parts, or plain enumeration.

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "coilwright/sizing/problem/archive.hpp"
#include "sizing/front_problems.hpp"

namespace {

using coilwright::sizing::FrontFrame;
using coilwright::sizing::Objectives;
using coilwright::sizing::Problem;

std::vector<Objectives> kept(const std::vector<Objectives>& points) {
  std::vector<Objectives> result;
  for (const std::size_t i : coilwright::sizing::non_dominated(points)) result.push_back(points[i]);
  return result;
}

// A million points on a curve: the staircase between them lacks about 1e-6 of the hypervolume.
std::vector<Objectives> curve(double from, double to, const std::function<std::vector<double>(double)>& design,
                              const Problem& problem) {
  constexpr int count = 1'000'000;
  std::vector<Objectives> points;
  points.reserve(count + 1);
  for (int i = 0; i <= count; ++i) {
    const auto evaluation = evaluate_checked(problem, design(std::lerp(from, to, static_cast<double>(i) / count)));
    // 1e-9: the curves run along constraints, which rounding may put on either side
    bool inside = evaluation.failure.empty();
    for (const double value : evaluation.constraints) inside = inside && value < 1e-9;
    if (inside) points.push_back(minimised(problem, evaluation));
  }
  return points;
}

void append(std::vector<Objectives>& to, std::vector<Objectives> from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

// x3 at its bound serves both objectives; the other three are convex, so the weighted sums give the whole front.
std::vector<Objectives> re21_front(const Problem& problem) {
  const auto design = [](double root) {
    const double low = std::numbers::sqrt2;
    return std::vector<double>{std::clamp(root, 1.0, 3.0), std::clamp(low * root, low, 3.0), low,
                               std::clamp(low * root, 1.0, 3.0)};
  };
  return kept(curve(1 / std::numbers::sqrt2, 3, design, problem));
}

std::vector<Objectives> bnh_front(const Problem& problem) {
  std::vector<Objectives> points = curve(
      0, 3,
      [](double x) {
        return std::vector<double>{x, x};
      },
      problem);
  append(points, curve(
                     3, 5,
                     [](double x) {
                       return std::vector<double>{x, 3.0};
                     },
                     problem));
  return kept(points);
}

// Along the line constraint from the least f1, up x1 = -2.5, then along the circle.
std::vector<Objectives> srn_front(const Problem& problem) {
  std::vector<Objectives> points = curve(
      3.7, 2.5,
      [](double y) {
        return std::vector<double>{3 * y - 10, y};
      },
      problem);
  append(points, curve(
                     2.5, std::sqrt(225 - 6.25),
                     [](double y) {
                       return std::vector<double>{-2.5, y};
                     },
                     problem));
  append(points, curve(
                     0, 2 * std::numbers::pi,
                     [](double angle) {
                       return std::vector<double>{15 * std::cos(angle), 15 * std::sin(angle)};
                     },
                     problem));
  return kept(points);
}

std::vector<Objectives> tnk_front(const Problem& problem) {
  const auto design = [](double angle) {
    const double radius = std::sqrt(1 + 0.1 * std::cos(16 * angle));
    return std::vector<double>{radius * std::sin(angle), radius * std::cos(angle)};
  };
  return kept(curve(0, std::numbers::pi / 2, design, problem));
}

// f1 and f2 are sums over (x1, x2), x3, x4 and (x5, x6), and so are the constraints: the front of a sum needs only the
// fronts of its parts. x4 = 0 serves both objectives. The grid is 1e-4 short in hypervolume; the five segments of Deb,
// Pratap, Meyarivan (EMO 2001, table 1), which lie on what it finds, make that up.
std::vector<Objectives> osy_front(const Problem& problem) {
  const auto part = [&](std::vector<double> x) {
    const std::vector<double> base{5, 1, 1, 0, 1, 0};
    const auto here = problem.evaluate(x), there = problem.evaluate(base);
    bool inside = true;
    for (const double value : here.constraints) inside = inside && value < 1e-12;
    return inside ? Objectives{here.objectives[0] - there.objectives[0], here.objectives[1] - there.objectives[1]}
                  : Objectives{1e9, 1e9};
  };
  constexpr int fine = 3000;
  std::vector<Objectives> plane, third, fifth;
  for (int i = 0; i <= fine; ++i) {
    for (int k = 0; k <= fine; ++k) plane.push_back(part({6.0 * i / fine, 4.0 * k / fine, 1, 0, 1, 0}));
    third.push_back(part({5, 1, 1 + 4.0 * i / fine, 0, 1, 0}));
    const double x5 = 1 + 4.0 * i / fine;
    fifth.push_back(part({5, 1, 1, 0, x5, std::max(0.0, 4 - (x5 - 3) * (x5 - 3))}));
  }
  const auto sum = [](const std::vector<Objectives>& a, const std::vector<Objectives>& b) {
    std::vector<Objectives> front;
    for (const Objectives& p : a) {
      for (const Objectives& q : b) front.push_back({p[0] + q[0], p[1] + q[1]});
      if (front.size() > 3'000'000) front = kept(front);
    }
    return kept(front);
  };
  std::vector<Objectives> front = sum(sum(kept(plane), kept(third)), kept(fifth));
  for (Objectives& point : front) {
    point[0] += problem.evaluate(std::vector<double>{5, 1, 1, 0, 1, 0}).objectives[0];
    point[1] += problem.evaluate(std::vector<double>{5, 1, 1, 0, 1, 0}).objectives[1];
  }
  using Design = std::vector<double>;
  append(front, curve(
                    1, 5, [](double t) { return Design{5, 1, t, 0, 5, 0}; }, problem));
  append(front, curve(
                    1, 5, [](double t) { return Design{5, 1, t, 0, 1, 0}; }, problem));
  append(front, curve(
                    4.056, 5, [](double t) { return Design{t, (t - 2) / 3, 1, 0, 1, 0}; }, problem));
  append(front, curve(
                    1, 3.732, [](double t) { return Design{0, 2, t, 0, 1, 0}; }, problem));
  append(front, curve(
                    0, 1, [](double t) { return Design{t, 2 - t, 1, 0, 1, 0}; }, problem));
  return kept(front);
}

void print(const char* name, const std::vector<Objectives>& front) {
  const FrontFrame frame = coilwright::sizing::frame_of(front);
  fmt::print("{},{:.12g},{:.12g},{:.12g},{:.12g},{:.8f}\n", name, frame.ideal[0], frame.nadir[0], frame.ideal[1],
             frame.nadir[1], coilwright::sizing::normalised_hypervolume(front, frame));
}

}  // namespace

int main() {
  namespace problems = coilwright::sizing::testing;
  fmt::print("name,ideal_1,nadir_1,ideal_2,nadir_2,hypervolume\n");
  print("RE21", re21_front(problems::re21()));
  print("BNH", bnh_front(problems::bnh()));
  print("SRN", srn_front(problems::srn()));
  print("TNK", tnk_front(problems::tnk()));
  // x1 runs over the front; all others have one value there, at which g is 1 (DTLZ2: the radius).
  const auto others_at = [](double value, std::size_t dimension) {
    return [value, dimension](double x) {
      std::vector<double> design(dimension, value);
      design[0] = x;
      return design;
    };
  };
  const std::vector<Objectives> zdt1 = kept(curve(0, 1, others_at(0, 30), problems::zdt1()));
  print("ZDT1", zdt1);
  print("ZDT1_2000", zdt1);
  print("ZDT2", kept(curve(0, 1, others_at(0, 30), problems::zdt2())));
  print("ZDT3", kept(curve(0, 1, others_at(0, 30), problems::zdt3())));
  print("ZDT6", kept(curve(0, 1, others_at(0, 10), problems::zdt6())));
  print("DTLZ2", kept(curve(0, 1, others_at(0.5, 12), problems::dtlz2())));
  print("CRE25", kept(problems::enumerate_feasible(problems::cre25())));
  print("OSY", osy_front(problems::osy()));
}
