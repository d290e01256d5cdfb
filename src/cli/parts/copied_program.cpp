#include "cli/parts/copied_program.hpp"

#include <link.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

#include "coilwright/text/opened_file.hpp"
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

void copy_whole(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  std::ifstream source = text::opened(from);
  text::OutputFile copy(to);
  text::copy_rest(source, from, copy.stream());
  copy.commit();
  fs::permissions(to, fs::status(from).permissions(), error);
}

std::vector<std::string> copy_program(const fs::path& folder) {
  std::vector<std::string> names{"coilwright"};
  copy_whole("/proc/self/exe", folder / names.front());
  for (const fs::path& library : loaded_libraries()) {
    names.push_back("lib/" + library.filename().string());
    copy_whole(library, folder / names.back());
  }
  return names;
}

}  // namespace coilwright::cli
