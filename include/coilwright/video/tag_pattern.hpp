#pragma once

namespace coilwright::video {

/// Number of tags: the first of ArUco's dictionary of 4 by 4 bits (DICT_4X4_50), which have a black border of one
/// module. Tag 0 is on the base, 1 and on are on the segments from the base to the tip.
inline constexpr int tag_count = 6;
/// Number of modules along a side, including the border. A margin of one white module is needed around it.
inline constexpr int tag_modules = 6;

/// Whether a module is white. `row` from the top and `column` from the left of the upright tag, from 0.
[[nodiscard]] bool is_white(int tag, int row, int column);

/// The board for calibrating a lens: a chessboard, whose inner corners are found.
inline constexpr int board_columns = 6;        ///< of inner corners
inline constexpr int board_rows = 9;           ///< of inner corners
inline constexpr double board_square = 0.025;  ///< m

}  // namespace coilwright::video
