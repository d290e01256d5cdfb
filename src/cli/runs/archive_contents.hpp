#pragma once

#include <string>
#include <vector>

#include "coilwright/archive/contents.hpp"
#include "coilwright/archive/reader.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::cli {

/// The name of the archive in a folder of results.
inline constexpr const char* archive_name = "archive.sqlite";

/// The archive in a folder that `option` names. Throws text::InputError naming the option where it cannot be read.
[[nodiscard]] archive::Reader archive_of(const char* option, const std::string& folder);

/// This program, as archives name it.
[[nodiscard]] archive::Program this_program();

/// How a study is searched: the algorithm, and what --start brought, by a digest. So a folder is not gone on with from
/// other designs.
[[nodiscard]] std::string way_of(const sizing::SearchOptions& search, const results::Provenance& provenance);

/// What the archive of a run is an archive of, but for a study: command, program, inputs and changes.
[[nodiscard]] archive::Contents contents_of(const results::Provenance& provenance);

/// What a folder that `differences` keep from being gone on with is refused with.
[[nodiscard]] std::string archive_of_another_run(const std::vector<std::string>& differences);

/// What the archive of a run of `study` is an archive of. A system that is built from the actuator is described by the
/// study's text alone. Seed and algorithm are the study's where the provenance has a
/// seed; a sample takes the place of the algorithm.
[[nodiscard]] archive::Contents contents_of(const sizing::Study& study, const results::Provenance& provenance,
                                            bool builds_a_system);

}  // namespace coilwright::cli
