#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace coilwright::cli {

/// The manual page of a command, or of the program itself, in the troff of man(7): what its --help says.
[[nodiscard]] std::string manual_page(const CLI::App& command);

/// Its file: "coilwright-rig-camera.1".
[[nodiscard]] std::string manual_page_name(const CLI::App& command);

}  // namespace coilwright::cli
