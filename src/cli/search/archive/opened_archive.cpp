#include "cli/search/archive/opened_archive.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/runs/archive_contents.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {

void add_archive_folder(CLI::App& command, std::string& folder) {
  command.add_option("DIR", folder, "Folder with the archive of a run of size, sweep or pareto")->required();
}

void add_row_option(CLI::App& command, std::int64_t& row) {
  command.add_option("--row", row, "Place of the design in the order of recording, from 1")
      ->required()
      ->transform(whole_number_rule(text::Rule::between(1, 1e15)));
}

archive::Reader opened_archive(const std::string& folder) {
  archive::Reader archive(std::filesystem::path(folder) / archive_name);
  const std::optional<results::Question> question = results::question_in(folder);
  if (question && (question->sha256 != archive.contents().question || question->seed != archive.contents().seed))
    throw text::InputError(
        {.file = archive.path().string(),
         .rule = fmt::format("is of another run than the results beside it ({}): move one of them away",
                             results::provenance_name)});
  if (!archive.has_checksums())
    std::cerr << fmt::format(
        "coilwright: {} was written by an earlier version, without checksums: whether a number "
        "of it has changed on the disk is not known\n",
        printed(archive.path()));
  return archive;
}

archive::Row row_of(const archive::Reader& archive, std::int64_t row) {
  if (std::optional<archive::Row> found = archive.row(row)) return *std::move(found);
  throw text::InputError({.file = archive.path().string(),
                          .place = {},
                          .rule = fmt::format("has {} designs, and none in row {}", archive.size(), row),
                          .value = {}});
}

sizing::DesignProblem problem_of(const archive::Contents& contents) {
  const std::size_t count = contents.inputs.size();
  if (count < 2 || count > 3)
    throw std::runtime_error("the archive has not the texts of a study, an actuator and perhaps a diagnosis");
  std::vector<text::InputText> texts;
  for (const archive::Input& input : contents.inputs) texts.push_back({.file = input.file, .text = input.text});
  return sizing::DesignProblem(formats::parse_study(
      texts[0].text, texts[0].file,
      {.changes = contents.changes, .actuator = &texts[1], .posterior = count == 3 ? &texts[2] : nullptr}));
}

std::vector<double> point_of(const sizing::DesignProblem& problem, const archive::Reader& archive,
                             const archive::Row& row) {
  if (std::optional<std::vector<double>> point = archive::point_of(problem.study(), row.variables))
    return *std::move(point);
  throw text::InputError({.file = archive.path().string(),
                          .place = fmt::format("row {}", row.id),
                          .rule = "must have values that the study's variables take",
                          .value = {}});
}

}  // namespace coilwright::cli
