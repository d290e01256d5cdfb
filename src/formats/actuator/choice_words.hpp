#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// What a file calls a value of a choice.
template <class Value>
using Word = std::pair<std::string_view, Value>;

using magnetics::CurrentDistribution;
inline constexpr auto winding_words =
    std::to_array<Word<CurrentDistribution>>({{"paper_shells", CurrentDistribution::paper_shells},
                                              {"layer_centres", CurrentDistribution::layer_centres},
                                              {"uniform", CurrentDistribution::uniform}});
inline constexpr auto fidelity_words = std::to_array<Word<magnetics::Fidelity>>(
    {{"line_of_centres", magnetics::Fidelity::line_of_centres}, {"exact", magnetics::Fidelity::exact}});
inline constexpr auto wiring_words = std::to_array<Word<actuator::Wiring>>(
    {{"parallel", actuator::Wiring::parallel}, {"series", actuator::Wiring::series}});
inline constexpr auto cases_words =
    std::to_array<Word<actuator::HeldCases>>({{"both", actuator::HeldCases::both},
                                              {"free", actuator::HeldCases::free},
                                              {"gripping", actuator::HeldCases::gripping}});

/// The word for a value, which `words` has.
template <class Words, class Value>
[[nodiscard]] constexpr std::string_view word_for(const Words& words, Value value) {
  return std::ranges::find(words, value, &Word<Value>::second)->first;
}

/// The value of one of `words`, or `otherwise` where the key is absent.
template <class Value, class Words>
[[nodiscard]] Value choice_or(text::ObjectReader& in, std::string_view key, Value otherwise, const Words& words) {
  const auto node = in.find(key);
  return node ? node->choice_among<Value>(words) : otherwise;
}

/// Calls `each(key, member, words)` for every choice of a design's model, in the order of its file.
template <class Each>
void for_each_model_choice(Each&& each) {
  using namespace actuator;
  each("winding", &ModelChoices::winding, winding_words);
  each("torque", &ModelChoices::torque, fidelity_words);
  each(
      "face_contact", &ModelChoices::faces,
      std::to_array<Word<ContactChoice>>({{"hard_parts", ContactChoice::hard_parts}, {"walls", ContactChoice::walls}}));
  each("segment_mass", &ModelChoices::masses,
       std::to_array<Word<SegmentMass>>(
           {{"on_axis_points", SegmentMass::on_axis_points}, {"rigid_bodies", SegmentMass::rigid_bodies}}));
  each("hinge", &ModelChoices::hinge,
       std::to_array<Word<HingeLaw>>({{"slit", HingeLaw::slit}, {"slot", HingeLaw::slot}, {"beam", HingeLaw::beam}}));
  each("damping", &ModelChoices::damping,
       std::to_array<Word<DampingLaw>>(
           {{"loss_factor", DampingLaw::loss_factor}, {"proportional", DampingLaw::proportional}}));
  each("ampacity", &ModelChoices::ampacity,
       std::to_array<Word<AmpacityChoice>>({{"law", AmpacityChoice::law}, {"table", AmpacityChoice::table}}));
  each("film", &ModelChoices::film,
       std::to_array<Word<FilmChoice>>({{"calibrated", FilmChoice::calibrated}, {"still_air", FilmChoice::still_air}}));
}

}  // namespace coilwright::formats
