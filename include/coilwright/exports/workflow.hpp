#pragma once

#include <string>
#include <vector>

namespace coilwright::exports {

/// A run in independent parts, in a folder that holds everything that it needs.
struct Workflow {
  std::string program{};                            ///< a file of the folder: "coilwright"
  std::vector<std::string> arguments{};             ///< of each part, for that program; no blanks inside one
  std::vector<std::vector<std::string>> outputs{};  ///< of each part, files from the folder on
  std::vector<std::string> inputs{};                ///< of every part, beside the program
  std::string merge{};                              ///< a command of sh that joins the outputs
  std::string result{};                             ///< the last file that it writes
  std::vector<std::string> slurm{};                 ///< options of sbatch for each part: "--time=2:00:00"
};

/// A file of the folder of a workflow.
struct WorkflowFile {
  std::string name{};
  std::string text{};
};

/// Writes the workflow for existing engines: arguments.txt, part.sh and merge.sh, which all of them call;
/// workflow.makeflow for makeflow.sh (Makeflow, with Work Queue on machines without a shared disk, or over Slurm, SGE,
/// HTCondor), slurm.sh (an array) and parallel.sh (GNU parallel on one machine); and progress.sh, which prints the
/// finished parts and the time left. Each continues after a crash. Only one makeflow.sh or parallel.sh runs at a time;
/// both fail if there is no result at the end. A part that exits with 4, because its machine gives other numbers, ends
/// the worker that would draw the next one.
[[nodiscard]] std::vector<WorkflowFile> workflow_files(const Workflow& workflow);

/// The name of a part's folder, "0003" of 3; the zeros keep the order in a listing.
[[nodiscard]] std::string part_folder(std::size_t number);

}  // namespace coilwright::exports
