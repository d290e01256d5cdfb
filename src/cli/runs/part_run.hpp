#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "coilwright/formats/study/part_file.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/part.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

/// The file by which a folder is known to hold a finished part of a run. It comes last.
inline constexpr const char* part_name = "part.json";
/// The table of a sweep.
inline constexpr const char* rows_name = "designs.csv";
/// What a part of a yield has beside it.
inline constexpr const char* builds_name = "builds.csv";

/// --part and --head of a command.
struct PartOptions {
  std::optional<sizing::Part> part{};
  std::string head{};
};

/// Adds both, after --json and --report, which a part has not. `what` says what a part is: "Evaluate the K-th of N
/// equal shares of the designs".
void add_part_options(CLI::App& command, PartOptions& options, const std::string& what);

/// " --part 3/40"; empty without a part.
[[nodiscard]] std::string part_text(const PartOptions& options);

/// This machine, with its figures of three designs of the range of a study: a Latin hypercube. What the study builds
/// from an actuator and its spread are not in them, as they may take long.
[[nodiscard]] formats::Machine this_machine(const sizing::DesignProblem& problem);
/// The same of three default designs, for runs that are of no study.
[[nodiscard]] formats::Machine this_machine();

/// Throws OtherMachine where --head names a machine whose figures differ from those of `here`.
void require_figures_of_head(const PartOptions& options, const formats::Machine& here);

/// What a part of `size` or `pareto` is: a search by a seed of its own, that of the study plus the number of the part,
/// less one. Sets it in `study`, and gives what is to become of part.json; nothing without --part. Throws as
/// require_figures_of_head().
[[nodiscard]] std::optional<formats::PartFile> begin_search_part(const PartOptions& options,
                                                                 results::Provenance provenance, sizing::Study& study);

/// What all parts of a run share. `how` are the options that decide what comes out, for the errors of merge.
[[nodiscard]] archive::Contents whole_of(const results::Provenance& provenance, const std::string& study,
                                         std::string how);

/// Writes part.json, and the results as found.json where there are any, into a folder, which may be locked and has all
/// other files of the part, and says so in a line of standard output. part.json names each of them with its digest.
void write_part(text::OutputFolder& folder, formats::PartFile part, std::optional<text::Json> results = {});

}  // namespace coilwright::cli
