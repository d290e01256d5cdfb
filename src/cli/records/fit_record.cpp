#include "cli/records/fit_record.hpp"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cli/runs/archive_contents.hpp"
#include "coilwright/archive/kept_fits.hpp"
#include "coilwright/archive/reader.hpp"
#include "coilwright/archive/writer.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;

// Whether the archive that is there is gone on with. Throws where it may be neither that nor replaced.
bool goes_on(const fs::path& path, const archive::Contents& asked, Begin begin) {
  std::error_code error;
  if (begin == Begin::force || !fs::exists(fs::symlink_status(path, error))) return false;
  const archive::Contents found = archive::Reader(path).contents();
  if (begin == Begin::anew && found.command == asked.command) return false;
  const std::vector<std::string> differing = archive::differences(found, asked);
  if (begin == Begin::resume && differing.empty()) return true;
  throw text::InputError(
      {.file = path.parent_path().string(), .place = {}, .rule = archive_of_another_run(differing), .value = {}});
}

// The archive of a run of another command, or what is none: it stays until the diagnosis that replaces it is written.
bool is_of_another_run(const fs::path& path, const archive::Contents& asked) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return false;
  try {
    return archive::Reader(path).contents().command != asked.command;
  } catch (const text::InputError&) {
    return true;
  }
}

void tell_of(const std::string& refusal) {
  std::cerr << fmt::format("coilwright: {}; the diagnosis goes on, and is recorded no further\n", refusal)
            << std::flush;
}

archive::KeptFits opened(const fs::path& path, const archive::Contents& asked, bool is_there) {
  if (!is_there) archive::create(path, asked);
  text::remove_left_parts(path);
  return archive::open_fits(path, tell_of);
}

}  // namespace

void FitRecord::remove() {
  known_fits.reset();
  std::error_code kept;
  fs::remove(path, kept);
}

void FitRecord::discard() {
  unlock();
  remove();
  std::error_code kept;
  if (is_new_folder) fs::remove(path.parent_path(), kept);
}

FitRecord open_fit_record(const fs::path& folder, const results::Provenance& question, std::string way, Begin begin) {
  const bool is_new_folder = fs::create_directories(folder);
  FitRecord out{.path = folder / archive_name,
                .lock = std::make_unique<text::FolderLock>(folder),
                .known_fits = nullptr,
                .is_new_folder = is_new_folder};
  archive::Contents asked = contents_of(question);
  asked.algorithm = std::move(way);
  asked.seed = question.seed;
  if (begin == Begin::force && is_of_another_run(out.path, asked)) {
    out.path.clear();
    return out;
  }
  const bool is_there = goes_on(out.path, asked, begin);
  try {
    const archive::KeptFits fits = opened(out.path, asked, is_there);
    out.known_fits = std::make_shared<const measurement::replay::KnownFits>(measurement::replay::KnownFits{
        .recall = [fits](const std::string& fit) { return fits.recall(results::sha256(fit)); },
        .keep = [fits](const std::string& fit, const std::string& found) { fits.keep(results::sha256(fit), found); },
        .differs =
            [path = out.path] {
              std::cerr
                  << fmt::format(
                         "coilwright: {}: a recorded fit has other numbers when it is evaluated again: it is made anew",
                         printed(path)) +
                         '\n'
                  << std::flush;
            }});
  } catch (const std::runtime_error& refusal) {
    tell_of(refusal.what());  // a record is no reason to go without an answer
  }
  return out;
}

}  // namespace coilwright::cli
