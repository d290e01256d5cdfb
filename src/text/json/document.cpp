#include "coilwright/text/json/document.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/json_pointer.hpp"
#include "text/json/json_parser.hpp"

namespace coilwright::text {

struct Document::Content {
  std::string file;
  Json root;
};

Document::Document(std::unique_ptr<const Content> content) : content_(std::move(content)) {}
Document::~Document() = default;
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;

Node Document::root() const {
  return Node(content_->file, content_->root, {}, {});
}

namespace {

// Where a plain value may stand; a key that is new is made. Null where the pointer leads nowhere.
Json* plain_value_at(Json& root, std::string_view pointer) {
  const auto steps = pointer_steps(pointer);
  if (!steps || steps->empty()) return nullptr;
  Json* value = &root;
  for (std::size_t i = 0; i < steps->size(); ++i) {
    const std::string& step = (*steps)[i];
    if (auto* array = std::get_if<Json::Array>(&value->content())) {
      const auto index = array_index(step);
      if (!index || *index >= array->size()) return nullptr;
      value = &(*array)[*index];
    } else if (auto* object = std::get_if<Json::Object>(&value->content())) {
      const auto found = std::ranges::find(*object, step, [](const auto& member) { return member.first; });
      if (found != object->end()) {
        value = &found->second;
      } else if (i + 1 == steps->size()) {
        value = &object->emplace_back(step, 0.0).second;
      } else {
        return nullptr;
      }
    } else {
      return nullptr;
    }
  }
  const bool plain = std::holds_alternative<bool>(value->content()) ||
                     std::holds_alternative<double>(value->content()) ||
                     std::holds_alternative<std::string>(value->content());
  return plain ? value : nullptr;
}

}  // namespace

Document Document::with_values(const std::map<std::string, PlainValue>& values) const {
  Content copy = *content_;
  for (const auto& [pointer, plain] : values) {
    Json* value = plain_value_at(copy.root, pointer);
    if (value == nullptr) throw std::invalid_argument("pointer must lead to a plain value; got " + pointer);
    std::visit([&](const auto& each) { value->content() = each; }, plain);
  }
  return Document(std::make_unique<const Content>(std::move(copy)));
}

Document parse_json(std::string_view text, std::string file) {
  Json root = parse_json_value(text, file);
  Document::Content content{.file = std::move(file), .root = std::move(root)};
  return Document(std::make_unique<const Document::Content>(std::move(content)));
}

Document read_json(const std::filesystem::path& path) {
  InputText read = read_text(path, json_size_limit);
  return parse_json(read.text, std::move(read.file));
}

}  // namespace coilwright::text
