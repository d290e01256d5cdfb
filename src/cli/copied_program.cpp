#include "copied_program.hpp"

#include <link.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> of_c_library{"ld-linux", "libc.so",  "libm.so",   "libpthread.so",
                                                       "libdl.so", "librt.so", "linux-vdso"};

bool is_copied(const fs::path& library) {
  const std::string name = library.filename().string();
  return !name.empty() &&
         std::ranges::none_of(of_c_library, [&](std::string_view each) { return name.starts_with(each); });
}

std::vector<fs::path> loaded_libraries() {
  std::vector<fs::path> out;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* list) {
        if (is_copied(info->dlpi_name)) static_cast<std::vector<fs::path>*>(list)->emplace_back(info->dlpi_name);
        return 0;
      },
      &out);
  return out;
}

}  // namespace

std::vector<std::string> copy_program(const fs::path& folder) {
  std::vector<std::string> names{"coilwright"};
  const auto copy = [&](const fs::path& from, const std::string& name) {
    std::error_code error;
    fs::create_directories((folder / name).parent_path(), error);
    fs::copy_file(from, folder / name, fs::copy_options::overwrite_existing, error);
    if (error) throw text::OutputError(folder / name, error.message(), text::OutputError::Stage::preparing);
  };
  copy("/proc/self/exe", names.front());
  for (const fs::path& library : loaded_libraries()) {
    names.push_back("lib/" + library.filename().string());
    copy(library, names.back());
  }
  return names;
}

}  // namespace coilwright::cli
