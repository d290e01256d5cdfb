#pragma once

#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/exports/exported_file.hpp"
#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// Writes the files of a kind that needs a geometry.
using DesignExport = std::vector<ExportedFile> (*)(const DesignSubject& subject, const ExportSettings& settings);

/// Writes the files of a kind that a model alone suffices for.
using ModelExport = std::vector<ExportedFile> (*)(const ModelSubject& subject, const ExportSettings& settings);

/// One kind of export: a row of the table that the command line offers.
struct ExportKind {
  std::string_view name;                               ///< "workshop"
  std::string_view gives;                              ///< what its files are, in a phrase
  std::string_view use;                                ///< what to do with them next, in one or two sentences
  std::span<const std::string_view> settings;          ///< names of the ExportSetting that it reads
  std::variant<DesignExport, ModelExport> write_text;  ///< by which it is made; see export_files()
};

/// Every kind.
[[nodiscard]] std::span<const ExportKind> export_kinds() noexcept;

/// The kind of that name; nullptr if there is none.
[[nodiscard]] const ExportKind* find_export_kind(std::string_view name) noexcept;

/// The files of one kind, at least one. Pure: the same subject and settings give the same bytes. Throws
/// std::invalid_argument where the kind needs a geometry and the subject has none, and as the kind says where it cannot
/// say what the subject has (an effect that its format does not know).
[[nodiscard]] std::vector<ExportedFile> export_files(const ExportKind& kind, const Subject& subject,
                                                     const ExportSettings& settings);

}  // namespace coilwright::exports
