#include "coilwright/formats/actuator/actuator_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/actuator/actuator_reader.hpp"

namespace coilwright::formats {
namespace {

using namespace text;

enum class Format { design, lumped_model };

ActuatorFile read_actuator_file(const Document& document, const actuator::EffectCatalogue& effects) {
  ActuatorContent read = read_actuator_content(document, effects);
  if (auto* content = std::get_if<DesignContent>(&read.content))
    return {.name = std::move(read.name),
            .content = std::move(content->design),
            .operating_point = content->operating_point};
  const auto& [model, magnetics] = std::get<LumpedModelContent>(read.content);
  try {
    return {.name = std::move(read.name), .content = actuator::Model(actuator::spec_of(model, magnetics))};
  } catch (const std::invalid_argument& mistake) {
    throw document.root().error_without_value(mistake.what());
  }
}

}  // namespace

ActuatorContent read_actuator_content(const Document& document, const actuator::EffectCatalogue& known) {
  return read_object(document.root(), [&known](ObjectReader& in) {
    const auto format =
        in.choice<Format>("format", {{"actuator/1", Format::design}, {"lumped-model/1", Format::lumped_model}});
    std::string name = in.name();
    (void)in.text_or("description", "");
    if (format == Format::design) return ActuatorContent{.name = std::move(name), .content = read_design(in, known)};
    return ActuatorContent{.name = std::move(name), .content = read_lumped_model(in, known)};
  });
}

ActuatorFile read_actuator(const std::filesystem::path& path, const actuator::EffectCatalogue& effects) {
  return read_actuator_file(read_json(path), effects);
}

ActuatorFile parse_actuator(std::string_view text, std::string file, const actuator::EffectCatalogue& effects) {
  return read_actuator_file(parse_json(text, std::move(file)), effects);
}

const actuator::Design& design_of(const ActuatorFile& file, const std::string& who, std::string_view reason) {
  if (const auto* design = std::get_if<actuator::Design>(&file.content)) return *design;
  throw text::InputError({.file = who, .rule = fmt::format("is a lumped model: {}", reason)});
}

}  // namespace coilwright::formats
