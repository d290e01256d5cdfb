#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace coilwright::archive {

/// The finished fits of a diagnosis in its archive: bytes, by a digest of what was asked. Both from any thread.
struct KeptFits {
  /// What was kept; nothing where there is none, or where it is not what was written.
  std::function<std::optional<std::string>(const std::string& asked)> recall{};
  /// Outlives the program, however it ends, once this returns; of a failing power supply the last few may be gone.
  std::function<void(const std::string& asked, const std::string& found)> keep{};
};

/// Opens an archive that create() made; closed with the last copy. `on_refusal` is told in one line once the disk has
/// refused two fits in a row, and why: nothing more is recorded then, nor waited for. Throws InputError where the file
/// is no archive, text::OutputError (preparing) where it cannot be written.
[[nodiscard]] KeptFits open_fits(const std::filesystem::path& path, std::function<void(const std::string&)> on_refusal);

}  // namespace coilwright::archive
