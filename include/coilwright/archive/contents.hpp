#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/sizing/study/study.hpp"

namespace coilwright::archive {

/// An input file of a study, kept whole, so that an archive needs no other file.
struct Input {
  std::string file{};    ///< the path as it was given
  std::string sha256{};  ///< of its bytes, 64 hexadecimal digits
  std::string text{};    ///< bytes of the file

  friend bool operator==(const Input&, const Input&) = default;
};

/// The program whose numbers an archive holds. Another program may give others.
struct Program {
  std::string version{};  ///< "0.1.0"
  std::string commit{};   ///< 40 hexadecimal digits; empty if it is not known
  std::string build{};    ///< SHA-256 of the program's file if the commit does not identify its sources; else empty

  friend bool operator==(const Program&, const Program&) = default;
};

/// The name of a program: "0.1.0 (commit 1234567)", with the first digits of a build if the commit does not identify
/// the sources.
[[nodiscard]] std::string name_of(const Program& program);

/// Digests of the texts that decide the numbers of a design beside its variables. They are equal if the texts are
/// equal.
struct Physics {
  std::string actuator{};   ///< of the study's actuator, with what --set changes
  std::string operation{};  ///< of its operating point
  std::string systems{};  ///< of the whole question where the study builds something from the actuator, or scatters it;
                          ///< else empty

  friend bool operator==(const Physics&, const Physics&) = default;
};

/// The content of a column of an archive.
enum class Role { variable, objective, constraint, quantity };

/// The name of a role: "variable", "objective", "constraint", "quantity".
[[nodiscard]] std::string_view name_of(Role role);

/// A column of the table of designs that the study brings.
struct Column {
  Role role{};            ///< kind of its content
  std::string name{};     ///< of the variable, the objective, the limit ("mass_g <= 70") or the quantity
  std::string meaning{};  ///< meaning of a quantity; "maximise" or "minimise" of an objective; else empty
  std::string column{};   ///< name in the table, unique whatever the case of its letters

  friend bool operator==(const Column&, const Column&) = default;
};

/// The subject of an archive: all that decides which designs are evaluated, and the numbers that come out.
struct Contents {
  std::string command{};                ///< "pareto"
  std::string study{};                  ///< name of the study
  Program program{};                    ///< program that evaluates
  std::vector<Input> inputs{};          ///< the study, then its actuator
  std::vector<std::string> changes{};   ///< each --set, "gap_mm=1.2"
  std::string question{};               ///< digest of inputs and changes
  Physics physics{};                    ///< of every design
  std::string algorithm{};              ///< of the search, or the sample; empty if nothing is drawn
  std::optional<std::uint64_t> seed{};  ///< absent if nothing is drawn
  std::vector<Column> columns{};        ///< by role, in the order of the study

  friend bool operator==(const Contents&, const Contents&) = default;
};

/// The columns of a study: its variables, objectives, limits and quantities.
[[nodiscard]] std::vector<Column> columns_of(const sizing::Study& study);

/// Lists why a run that asks for `asked` cannot continue in an archive of `found`, each as a part of a sentence: "seed
/// 5, not 6". Empty if it can: both have the same command, program, inputs, changes, algorithm, seed and columns.
[[nodiscard]] std::vector<std::string> differences(const Contents& found, const Contents& asked);

/// Lists why an archive of `found` cannot answer designs of the study `asked`. Both must share the program, the physics
/// and the names of the variables, and the archive must have every quantity of `asked`.
[[nodiscard]] std::vector<std::string> differences_for_reuse(const Contents& found, const Contents& asked);

}  // namespace coilwright::archive
