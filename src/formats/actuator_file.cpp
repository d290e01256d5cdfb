#include "coilwright/formats/actuator_file.hpp"

#include <utility>

#include "coilwright/formats/json_document.hpp"
#include "coilwright/formats/object_reader.hpp"
#include "design_reader.hpp"
#include "lumped_model_reader.hpp"

namespace coilwright::formats {
namespace {

enum class Format { design, lumped_model };

ActuatorFile read_actuator_file(const Document& document) {
  return read_object(document.root(), [](ObjectReader& in) {
    const auto format =
        in.choice<Format>("format", {{"actuator/1", Format::design}, {"lumped-model/1", Format::lumped_model}});
    std::string name = in.text_or("name", "");
    (void)in.text_or("description", "");
    if (format == Format::design) return ActuatorFile{.name = std::move(name), .content = read_design(in)};
    return ActuatorFile{.name = std::move(name), .content = read_lumped_model(in)};
  });
}

}  // namespace

ActuatorFile read_actuator(const std::filesystem::path& path) {
  return read_actuator_file(read_json(path));
}

ActuatorFile parse_actuator(std::string_view text, std::string file) {
  return read_actuator_file(parse_json(text, std::move(file)));
}

}  // namespace coilwright::formats
