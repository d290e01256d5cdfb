#pragma once

#include <utility>
#include <variant>

namespace coilwright::text {

/// A std::variant whose copy may fail. The copy constructor of GCC 12's library destroys a content that was never made
/// where the memory for it runs out and all alternatives are numbers, texts or vectors. Here the copy is an assignment
/// to the first alternative, whose default must need no memory.
template <class First, class... Others>
class Variant : public std::variant<First, Others...> {
 public:
  using Base = std::variant<First, Others...>;  ///< What std::visit and std::get take.
  using Base::Base;
  using Base::operator=;
  Variant() = default;  ///< the default of the first alternative
  /// The same content; throws what the copy of the content throws, and then leaves nothing.
  Variant(const Variant& other) : Base(std::in_place_index<0>) { Base::operator=(other); }
  Variant(Variant&&) noexcept = default;             ///< \copydoc std::variant
  Variant& operator=(const Variant&) = default;      ///< \copydoc std::variant
  Variant& operator=(Variant&&) noexcept = default;  ///< \copydoc std::variant
  ~Variant() = default;
};

}  // namespace coilwright::text
