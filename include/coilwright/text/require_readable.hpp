#pragma once

#include <filesystem>

namespace coilwright::text {

/// Checks a file that another library reads. Throws InputError if it is no regular file, cannot be opened or is empty.
void require_readable(const std::filesystem::path& path);

}  // namespace coilwright::text
