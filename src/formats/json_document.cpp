#include "coilwright/formats/json_document.hpp"

#include <utility>

#include "input_file.hpp"
#include "json_parser.hpp"
#include "json_value.hpp"

namespace coilwright::formats {

struct Document::Content {
  std::string file;
  JsonValue root;
};

Document::Document(std::unique_ptr<const Content> content) : content_(std::move(content)) {}
Document::~Document() = default;
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;

Node Document::root() const {
  return Node(content_->file, content_->root, {}, {});
}

Document parse_json(std::string_view text, std::string file) {
  JsonValue root = parse_json_value(text, file);
  Document::Content content{.file = std::move(file), .root = std::move(root)};
  return Document(std::make_unique<const Document::Content>(std::move(content)));
}

Document read_json(const std::filesystem::path& path) {
  InputFile file(path, json_size_limit);
  std::string text;
  constexpr std::size_t block = 1 << 16;
  for (std::size_t filled = 0;; filled = text.size()) {
    text.resize(filled + block);
    text.resize(filled + file.read({text.data() + filled, block}).size());
    if (text.size() < filled + block) break;
  }
  return parse_json(text, file.name());
}

}  // namespace coilwright::formats
