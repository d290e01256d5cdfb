#pragma once

#include <array>

namespace coilwright::simulation {

/// Coefficients of a Rosenbrock method in the form that needs no product with the Jacobian (Hairer and Wanner, Solving
/// Ordinary Differential Equations II, section IV.7): stage i solves
///
///   (1 / (gamma h) - J) u_i = f(y + sum over j < i of a_ij u_j) + (1 / h) sum over j < i of c_ij u_j.
///
/// The place y + sum of a_ij u_j of each of the last stages is that of the stage before it plus that stage's own u, and
/// the step ends at the last place plus the last u, which is the estimate of the error.
struct RosenbrockMethod {
  static constexpr int stages = 8;
  static constexpr int own_places = 6;   ///< stages whose place has a row of `place`; of the others it follows
  static constexpr int dense_terms = 3;  ///< see RosenbrockStep::at
  int order{};                           ///< of the end; that without the last stage is of one order less
  double gamma{};
  std::array<std::array<double, own_places - 1>, own_places> place{};  ///< a_ij
  std::array<std::array<double, stages - 1>, stages> carry{};          ///< c_ij
  std::array<std::array<double, stages>, dense_terms> dense{};         ///< h_ij
};

/// Rodas5P of G. Steinebach, Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the Julia
/// Differential Equations package, BIT Numerical Mathematics 63 (2023) 27: order 5(4), eight stages, stiffly accurate
/// and L-stable, dense output of order 4, little order reduction on stiff problems. The coefficients are those of the
/// author's own implementation there; the tests check them by the order conditions.
inline constexpr RosenbrockMethod rodas5p{
    .order = 5,
    .gamma = 0.21193756319429014,
    .place = {{{},
               {3.0},
               {2.849394379747939, 0.45842242204463923},
               {-6.954028509809101, 2.489845061869568, -10.358996098473584},
               {2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641},
               {-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256,
                0.030198172008377946}}},
    .carry = {{{},
               {-14.155112264123755},
               {-17.97296035885952, -2.859693295451294},
               {147.12150275711716, -1.41221402718213, 71.68940251302358},
               {165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306},
               {24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471},
               {30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783, -19.097331116725623,
                -28.087943162872662},
               {37.80277123390563, -3.2571969029072276, 112.26918849496327, 66.9347231244047, -40.06618937091002,
                -54.66780262877968, -9.48861652309627}}},
    .dense = {{{25.948786856663858, -2.5579724845846235, 10.433815404888879, -2.3679251022685204, 0.524948541321073,
                1.1241088310450404, 0.4272876194431874, -0.17202221070155493},
               {-9.91568850695171, -0.9689944594115154, 3.0438037242978453, -24.495224566215796, 20.176138334709044,
                15.98066361424651, -6.789040303419874, -6.710236069923372},
               {11.419903575922262, 2.8879645146136994, 72.92137995996029, 80.12511834622643, -52.072871366152654,
                -59.78993625266729, -0.15582684282751913, 4.883087185713722}}}};

}  // namespace coilwright::simulation
