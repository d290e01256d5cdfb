#pragma once

#include <string>
#include <vector>

#include "coilwright/text/json/json.hpp"

namespace coilwright::results {

/// The state of the repository that this program was built from.
struct Commit {
  std::string hash{};   ///< 40 hexadecimal digits; empty where the sources were in no repository of their own
  bool changed{false};  ///< what is built differed from that commit
  /// SHA-256 over the sources; empty where the commit tells them.
  std::string sources{};
};

/// Of the sources of this program.
[[nodiscard]] Commit commit();

/// A library of another project that is built in.
struct Library {
  std::string name{};
  std::string version{};  ///< that the build found; "unknown" where its package states none
};

/// In the order in which the build asks for them.
[[nodiscard]] std::vector<Library> libraries();

/// Why no page can be made: this build has nothing to draw with. Empty where one can.
[[nodiscard]] std::string why_no_page();

/// "0.1.0".
[[nodiscard]] std::string version();

/// "GNU 12.2.0", as CMake calls it.
[[nodiscard]] std::string compiler();

/// What --version prints: version, commit, compiler and libraries in three lines, the last without its end.
[[nodiscard]] std::string version_text();

/// The same for programs.
[[nodiscard]] text::Json version_json();

}  // namespace coilwright::results
