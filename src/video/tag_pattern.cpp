#include "coilwright/video/tag_pattern.hpp"

#include <array>
#include <cstdint>

namespace coilwright::video {
namespace {

// Rows of four bits from the top, the left one first; 1 is white.
constexpr std::array<std::uint16_t, tag_count> inner_bits = {0b1011'0101'0011'0010, 0b0000'1111'1001'1010,
                                                             0b0011'0011'0010'1101, 0b1001'1001'0100'0110,
                                                             0b0101'0100'1001'1110, 0b0111'1001'1100'1101};

}  // namespace

bool is_white(int tag, int row, int column) {
  constexpr int inner = tag_modules - 2;
  if (row < 1 || row > inner || column < 1 || column > inner) return false;
  const int bit = (row - 1) * inner + (column - 1);
  return ((inner_bits.at(static_cast<std::size_t>(tag)) >> (inner * inner - 1 - bit)) & 1) != 0;
}

}  // namespace coilwright::video
