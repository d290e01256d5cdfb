#include "coilwright/text/input_text.hpp"

#include "text/input_file.hpp"

namespace coilwright::text {

InputText read_text(const std::filesystem::path& path, std::size_t size_limit) {
  InputFile file(path, size_limit);
  InputText read{.file = file.name(), .text = {}};
  constexpr std::size_t block = 1 << 16;
  for (std::size_t filled = 0;; filled = read.text.size()) {
    read.text.resize(filled + block);
    read.text.resize(filled + file.read({read.text.data() + filled, block}).size());
    if (read.text.size() < filled + block) return read;
  }
}

}  // namespace coilwright::text
