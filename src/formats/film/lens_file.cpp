#include "coilwright/formats/film/lens_file.hpp"

#include <algorithm>

#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

video::Lens read_lens(const std::filesystem::path& path) {
  using namespace text;
  const Document document = read_json(path);
  return read_object(document.root(), [](ObjectReader& in) {
    const Rule pixels = Rule::between(1, 1e5);
    in.literal("format", "lens/1");
    video::Lens out{.width = in.integer("width_px", pixels), .height = in.integer("height_px", pixels)};
    const auto focal = in.numbers("focal_px", Length::exactly(2), positive);
    const auto centre = in.numbers("centre_px", Length::exactly(2), Rule::between(-1e5, 1e5));
    const auto distortion = in.numbers("distortion", Length::exactly(5), Rule::between(-10, 10));
    static_cast<void>(in.number("rms_px", non_negative));  // for people
    out.focal = {focal[0], focal[1]};
    out.centre = {centre[0], centre[1]};
    std::ranges::copy(distortion, out.distortion.begin());
    return out;
  });
}

text::Json to_json(const video::CalibratedLens& calibrated) {
  using text::Json;
  const video::Lens& lens = calibrated.lens;
  return Json::object({{"format", "lens/1"},
                       {"width_px", lens.width},
                       {"height_px", lens.height},
                       {"focal_px", Json::array({lens.focal.x(), lens.focal.y()})},
                       {"centre_px", Json::array({lens.centre.x(), lens.centre.y()})},
                       {"distortion", Json::numbers(lens.distortion)},
                       {"rms_px", calibrated.rms}});
}

}  // namespace coilwright::formats
