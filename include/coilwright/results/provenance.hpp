#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/text/input_text.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::results {

/// The name of the file in a folder of results that states their origin.
inline constexpr const char* provenance_name = "provenance.json";

/// An input file of a result.
struct InputRecord {
  std::string file{};    ///< the path as it was given; "standard input"
  std::string sha256{};  ///< of its bytes
  std::string text{};    ///< bytes of the file
};

/// The record of a file that has been read.
[[nodiscard]] InputRecord record_of(const text::InputText& input);

/// The record of a file on disk. Throws InputError if it cannot be read.
[[nodiscard]] InputRecord record_of(const std::filesystem::path& file);

/// The inputs of a result beside the program, enough to reproduce it.
struct Provenance {
  std::string command{};                ///< "size"
  std::vector<InputRecord> inputs{};    ///< in the order in which the command names them
  std::vector<InputRecord> starts{};    ///< the designs of other runs that a search starts from, by their archives
  std::vector<std::string> changes{};   ///< each --set, "gap_mm=1.2"
  std::optional<std::uint64_t> seed{};  ///< absent if nothing is drawn
  std::string sample{};                 ///< of a sweep, "random of 1000 designs"; empty if it draws none
};

/// A number for "the same question": the SHA-256 of a text with a line for the digest of each input and for each
/// change, in their order. Paths, seed, threads and the version of the program are not included.
[[nodiscard]] std::string hash_of(const Provenance& provenance);

/// Writes provenance.json into a folder whose other files are complete. provenance/1 has `provenance`, the version and
/// the commit of the program, the SHA-256 of each other file, and one of all this. Throws OutputError (writing).
void write_provenance(text::OutputFolder& folder, const Provenance& provenance);

/// The question that the results of a folder answer, by its provenance.json.
struct Question {
  std::string sha256{};                 ///< hash_of() of the results' question
  std::optional<std::uint64_t> seed{};  ///< absent if nothing is drawn
};
/// Reads the question of a folder; absent if it has no such file. Throws InputError if it cannot be read.
[[nodiscard]] std::optional<Question> question_in(const std::filesystem::path& folder);

/// What the results of a folder were computed from, by its provenance.json.
struct InputsBehind {
  std::vector<std::string> files{};    ///< as they were given, in the order in which the command names them; >= 1
  std::vector<std::string> changes{};  ///< each --set
  std::string changed{};               ///< the first file that is not there as it was; empty: all are
};
/// Reads them, and looks for the files. Absent if the folder has no provenance.json. Throws InputError if it is none.
[[nodiscard]] std::optional<InputsBehind> inputs_behind(const std::filesystem::path& folder);

/// Why the results of a folder cannot be checked: it has no provenance.json, or one without digests. Empty if it has
/// them.
[[nodiscard]] std::string why_unchecked(const std::filesystem::path& folder);

/// Checks the results of a folder: if it has digests, each file that they name must be as it was written, and each of
/// `present` must be named. Throws InputError naming the first file that is not.
void require_as_written(const std::filesystem::path& folder, std::span<const std::filesystem::path> present);

}  // namespace coilwright::results
