#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

#include "cli/film/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/formats/film/lens_file.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/require_readable.hpp"

namespace coilwright::cli {
namespace {

struct LensOptions {
  std::string film;
  std::string out;
  bool force{false};
  bool json{false};
};

// Views that are apart: of a hand-held board, pictures that follow each other are one view.
bool is_new(const std::vector<video::Place>& board, const std::vector<std::vector<video::Place>>& boards, double far) {
  return std::ranges::all_of(boards, [&](const auto& other) {
    double largest = 0.0;
    for (std::size_t i = 0; i < board.size(); ++i) largest = std::max(largest, (board[i] - other[i]).norm());
    return largest > far;
  });
}

video::CalibratedLens calibrate(const std::string& file) {
  text::require_readable(file);
  const video::Vision& vision = video::load_vision();
  std::vector<std::vector<video::Place>> boards;
  video::Picture picture;
  constexpr std::size_t enough = 40;
  constexpr std::size_t fewest = 6;
  try {
    const auto source = vision.open(file);
    while (boards.size() < enough && source->next(picture))
      if (auto board = vision.find_board(picture); board && is_new(*board, boards, 0.03 * picture.width))
        boards.push_back(std::move(*board));
    if (boards.size() < fewest)
      throw std::runtime_error(
          fmt::format("must show the whole board of `coilwright tag` in {} views or more that differ; it does in {}",
                      fewest, boards.size()));
    return vision.calibrate(boards, picture.width, picture.height);
  } catch (const std::runtime_error& rule) {
    throw text::InputError({.file = file, .place = "", .rule = rule.what(), .value = ""});
  }
}

void run_lens(const LensOptions& options) {
  keep_inputs({options.film}, {options.out});
  text::OutputFile file(options.out);
  const video::CalibratedLens lens = calibrate(options.film);
  file.stream() << formats::to_json(lens).text();
  keep_other_kind(file, json_mark, options.force);
  file.commit();
  if (options.json)
    std::cout << written_json({options.out}).text();
  else
    report_stream(options.out) << fmt::format("{}: the corners are {:.3g} px from where this lens draws them\n",
                                              printed(options.out), lens.rms);
}

}  // namespace

void add_lens_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<LensOptions>();
  CLI::App* command = add_command(app, "lens");
  command->add_option("FILM", options->film, "Film of the board from all sides, in the mode that fingers are filmed in")
      ->required()
      ->check(file_rule());
  command->add_option("--out", options->out, "File to write (lens/1)")->required()->check(not_empty());
  add_force_option(*command, options->force);
  add_written_json_option(*command, options->json);
  command->footer(
      "A zoom, another focus or another mode (slow motion) is another lens.\n\n"
      "Example:\n"
      "  coilwright lens board.mp4 --out lens.json");
  command->callback([options] {
    require_file_for_json(options->json, options->out);
    run_lens(*options);
  });
}

}  // namespace coilwright::cli
