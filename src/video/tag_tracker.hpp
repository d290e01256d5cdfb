#pragma once

#include <map>
#include <vector>

#include "coilwright/video/vision.hpp"
#include "video/tag_fit.hpp"

namespace coilwright::video {

/// Finds the tags of one picture after the other, first where they must have gone.
class TagTracker {
 public:
  explicit TagTracker(const Vision& vision) : vision_(vision) {}
  /// The tags of a picture, by id. Throws std::runtime_error where two are alike.
  [[nodiscard]] std::vector<Sighting> tags_of(const Picture& picture);

 private:
  struct Known {
    double time{};
    TagFit fit{};
    Place velocity = Place::Zero();  // px/s
    double turn{};                   // rad/s
    bool lost{};
  };

  [[nodiscard]] std::optional<TagFit> follow(const Picture& picture, const Known& known);
  [[nodiscard]] std::optional<TagFit> search_near(const Picture& picture, const Known& known);
  void search_all(const Picture& picture, std::map<int, TagFit>& found);
  void remember(double time, const TagFit& fit);

  const Vision& vision_;
  TagTemplates templates_;
  std::map<int, Known> known_;
  int since_search_all_ = 0;
};

}  // namespace coilwright::video
