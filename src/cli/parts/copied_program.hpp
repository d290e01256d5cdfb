#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace coilwright::cli {

/// Copies a file with its permissions, and makes the folders to it; the copy is whole, or not there. Throws
/// text::OutputError, and InputError where it cannot be read.
void copy_whole(const std::filesystem::path& from, const std::filesystem::path& to);

/// Copies this program and the shared libraries that it uses into a folder ("coilwright", "lib/..."), so that it runs
/// on machines that have none of them, and gives their names. Those of the C library stay: every machine has its own,
/// and it must be as new as that of this one. Throws text::OutputError.
std::vector<std::string> copy_program(const std::filesystem::path& folder);

}  // namespace coilwright::cli
