#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace coilwright::archive {

/// The finished fits of a diagnosis in its archive, as bytes under a digest of what was asked. Both functions may be
/// called from any thread.
struct KeptFits {
  /// Returns what was kept under this digest; absent if there is nothing, or if it is not what was written.
  std::function<std::optional<std::string>(const std::string& asked)> recall{};
  /// Keeps `found`. Once it returns, the entry survives the end of the program; a power failure may lose the last few
  /// entries.
  std::function<void(const std::string& asked, const std::string& found)> keep{};
};

/// Opens an archive that create() made; the last copy closes it. After the disk has refused two fits in a row,
/// `on_refusal` gets one line with the reason, and nothing more is recorded. Throws InputError if the file is no
/// archive, and text::OutputError (preparing) if it cannot be written.
[[nodiscard]] KeptFits open_fits(const std::filesystem::path& path, std::function<void(const std::string&)> on_refusal);

}  // namespace coilwright::archive
