#pragma once

#include <string>
#include <vector>

#include "coilwright/text/json/json.hpp"

namespace coilwright::results {

/// The state of the repository from which this program was built.
struct Commit {
  std::string hash{};   ///< 40 hexadecimal digits; empty if the sources were in no repository of their own
  bool changed{false};  ///< whether the sources differed from that commit
  /// SHA-256 over the sources; empty if the commit identifies them.
  std::string sources{};
};

/// The commit of the sources of this program.
[[nodiscard]] Commit commit();

/// A library of another project that is part of this program.
struct Library {
  std::string name{};
  std::string version{};  ///< the version that the build found; "unknown" if its package states none
};

/// All such libraries, in the order in which the build finds them.
[[nodiscard]] std::vector<Library> libraries();

/// Why this build cannot make pages: it lacks the drawing scripts. Empty if it can.
[[nodiscard]] std::string why_no_page();

/// The version of this program: "0.1.0".
[[nodiscard]] std::string version();

/// The compiler, as CMake calls it: "GNU 12.2.0".
[[nodiscard]] std::string compiler();

/// The output of --version: version, commit, compiler and libraries in three lines, the last without its line end.
[[nodiscard]] std::string version_text();

/// The content of version_text() as JSON.
[[nodiscard]] text::Json version_json();

}  // namespace coilwright::results
