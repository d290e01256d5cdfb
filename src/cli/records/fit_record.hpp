#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "coilwright/measurement/replay/known_fits.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/text/output/folder_lock.hpp"

namespace coilwright::cli {

/// How a diagnosis begins in a folder with the archive of one that was cut short.
enum class Begin {
  anew,    ///< it is replaced, unless it is another command's
  resume,  ///< the run goes on from its fits, if they are of the same question
  force    ///< an archive of a diagnosis is replaced; with one of another run there, none is made
};

/// The finished fits of a diagnosis in the archive of its folder. Keeps other runs from the folder until unlock().
struct FitRecord {
  std::filesystem::path path;  ///< empty where another run has its archive, which is replaced with its results
  std::unique_ptr<text::FolderLock> lock;
  std::shared_ptr<const measurement::replay::KnownFits> known_fits;  ///< null where the disk takes none
  bool is_new_folder;                                                ///< it was made for this run

  /// Lets results be written to the folder.
  void unlock() { lock.reset(); }
  /// There is an answer: the archive goes, and no fit may use it any more.
  void remove();
  /// There will be none: of what was made for this run nothing stays.
  void discard();
};

/// `way`: what else decides the fits beside files and seed. Where an archive cannot be written, standard error is told,
/// and there is none. Throws text::InputError where the one that is there may not be used, text::OutputError
/// (preparing) where another run writes to the folder.
[[nodiscard]] FitRecord open_fit_record(const std::filesystem::path& folder, const results::Provenance& question,
                                        std::string way, Begin begin);

}  // namespace coilwright::cli
