#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>

namespace coilwright::simulation {

struct DesignView;

/// Results that several quantities of one design share: the grasp of a gripper gives a margin, a closing time and
/// forces. Safe to use from several threads.
class SharedResults {
 public:
  /// The result kept for `maker`, or nullptr.
  [[nodiscard]] std::shared_ptr<const void> find(const std::shared_ptr<const void>& maker) const {
    const std::scoped_lock lock{guard_};
    const auto found = kept_.find(maker);
    return found == kept_.end() ? nullptr : found->second;
  }
  /// Keeps a result and returns the kept one: of two that were made at the same time the first.
  std::shared_ptr<const void> keep(const std::shared_ptr<const void>& maker,
                                   const std::shared_ptr<const void>& result) {
    const std::scoped_lock lock{guard_};
    return kept_.try_emplace(maker, result).first->second;
  }

 private:
  mutable std::mutex guard_;
  // The makers live as long: another one at the address of one that is gone would find its result.
  std::map<std::shared_ptr<const void>, std::shared_ptr<const void>> kept_;
};

/// A result from which several quantities are read. It is made when the first of them is requested, once for each
/// design. Immutable; copies are cheap and share the result.
template <class Result>
class SharedResult {
 public:
  /// Makes the result of a design; must be pure.
  using Make = std::function<Result(const DesignView&)>;
  /// Stores `make`, which makes the result of a design.
  explicit SharedResult(Make make) : make_(std::make_shared<const Make>(std::move(make))) {}

  /// The result of a design. It is made anew at each call if the view keeps no results.
  template <class View>
  requires std::is_same_v<View, DesignView>
  [[nodiscard]] std::shared_ptr<const Result> of(const View& design) const {
    if (design.shared != nullptr)
      if (auto kept = design.shared->find(make_)) return std::static_pointer_cast<const Result>(kept);
    auto made = std::make_shared<const Result>((*make_)(design));  // without the lock: it may ask for other results
    if (design.shared == nullptr) return made;
    return std::static_pointer_cast<const Result>(design.shared->keep(make_, made));
  }

 private:
  std::shared_ptr<const Make> make_;  // the key, too
};

}  // namespace coilwright::simulation
