#include "video/tag_tracker.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "coilwright/video/tag_pattern.hpp"

namespace coilwright::video {
namespace {

// Of a tag that was not followed before, in modules: an outline is known to about a pixel, and its blur is not.
constexpr std::array first_blurs = {0.15, 0.3, 0.6};

double px_a_module(const TagFit& fit) {
  return std::sqrt(std::abs(fit.sighting.shape.determinant()));
}

// The white margin is seen too.
bool is_inside(const TagCorners& tag, const Picture& picture) {
  return std::ranges::all_of(tag.corners, [&](const Place& corner) {
    return corner.minCoeff() > 1.0 && corner.x() < picture.width - 2 && corner.y() < picture.height - 2;
  });
}

Area around(const Place& place, double reach, const Picture& picture) {
  const int left = std::clamp(static_cast<int>(place.x() - reach), 0, picture.width - 1);
  const int top = std::clamp(static_cast<int>(place.y() - reach), 0, picture.height - 1);
  const int right = std::clamp(static_cast<int>(place.x() + reach), left + 1, picture.width);
  const int bottom = std::clamp(static_cast<int>(place.y() + reach), top + 1, picture.height);
  return {.left = left, .top = top, .width = right - left, .height = bottom - top};
}

std::optional<TagFit> fit_outline(const Picture& picture, const TagCorners& outline, TagTemplates& templates) {
  for (const double blur : first_blurs)
    if (auto fit = fit_tag(picture, outline.id, to_tag(outline), blur, templates)) return fit;
  return std::nullopt;
}

void require_unlike(const std::vector<TagCorners>& tags) {
  std::set<int> ids;
  for (const TagCorners& tag : tags)
    if (!ids.insert(tag.id).second)
      throw std::runtime_error(fmt::format("must show each tag once; tag {} is there twice in one picture", tag.id));
}

}  // namespace

std::vector<Sighting> TagTracker::tags_of(const Picture& picture) {
  std::map<int, TagFit> found;
  bool missing = known_.empty();
  for (auto& [id, known] : known_) {
    auto fit = known.lost ? std::nullopt : follow(picture, known);
    if (!fit) fit = search_near(picture, known);
    if (fit)
      found.emplace(id, *fit);
    else
      missing = true;
  }
  // A tag that is not where it must have gone is searched everywhere, one that was never seen now and then.
  constexpr int seldom = 32;
  if (since_search_all_++ >= seldom || missing) search_all(picture, found);
  for (auto& [id, known] : known_) known.lost = !found.contains(id);
  std::vector<Sighting> out;
  for (const auto& [id, fit] : found) {
    remember(picture.time, fit);
    out.push_back(fit.sighting);
  }
  return out;
}

std::optional<TagFit> TagTracker::follow(const Picture& picture, const Known& known) {
  const double elapsed = picture.time - known.time;
  const Place from = known.fit.sighting.centre;
  const ToTag expected = moved(known.fit.homography, from, from + elapsed * known.velocity, elapsed * known.turn);
  auto fit = fit_tag(picture, known.fit.sighting.id, expected, known.fit.blur, templates_);
  // Where it began to move or stopped, it is nearer to where it was.
  if (!fit && (elapsed * known.velocity).norm() > 0.3 * px_a_module(known.fit))
    fit = fit_tag(picture, known.fit.sighting.id, known.fit.homography, known.fit.blur, templates_);
  return fit;
}

std::optional<TagFit> TagTracker::search_near(const Picture& picture, const Known& known) {
  const double elapsed = picture.time - known.time;
  const Place expected = known.fit.sighting.centre + elapsed * known.velocity;
  const double reach = 2.0 * tag_modules * px_a_module(known.fit);
  for (const TagCorners& tag : vision_.find_tags(picture, around(expected, reach, picture)))
    if (tag.id == known.fit.sighting.id)
      if (auto fit = fit_outline(picture, tag, templates_)) return fit;
  return std::nullopt;
}

void TagTracker::search_all(const Picture& picture, std::map<int, TagFit>& found) {
  since_search_all_ = 0;
  const auto tags = vision_.find_tags(picture, {.width = picture.width, .height = picture.height});
  require_unlike(tags);
  for (const TagCorners& tag : tags) {
    if (found.contains(tag.id) || !is_inside(tag, picture)) continue;
    if (auto fit = fit_outline(picture, tag, templates_)) found.emplace(tag.id, *fit);
  }
}

void TagTracker::remember(double time, const TagFit& fit) {
  Known& known = known_[fit.sighting.id];
  const double elapsed = time - known.time;
  const bool first = known.fit.blur == 0.0 || elapsed <= 0.0;
  known.velocity = first ? Place::Zero() : Place((fit.sighting.centre - known.fit.sighting.centre) / elapsed);
  known.turn =
      first ? 0.0
            : std::remainder(picture_angle(fit.sighting.shape) - picture_angle(known.fit.sighting.shape), 2.0 * M_PI) /
                  elapsed;
  known.time = time;
  known.fit = fit;
}

}  // namespace coilwright::video
