#pragma once

#include <string>
#include <vector>

namespace coilwright::exports {

/// Work in parts of which none needs another, in a folder that holds all that it needs.
struct Workflow {
  std::string program{};                            ///< a file of the folder: "coilwright"
  std::vector<std::string> arguments{};             ///< of each part, for that program; no blanks inside one
  std::vector<std::vector<std::string>> outputs{};  ///< of each part, files from the folder on
  std::vector<std::string> inputs{};                ///< of every part, beside the program
  std::string merge{};                              ///< a command of sh that puts the outputs together
  std::string result{};                             ///< the last file that it writes
  std::vector<std::string> slurm{};                 ///< options of sbatch for each part: "--time=2:00:00"
};

/// A file of a folder.
struct WorkflowFile {
  std::string name{};
  std::string text{};
};

/// The workflow for engines that are installed already: arguments.txt, part.sh and merge.sh, which all of them call;
/// workflow.makeflow, for makeflow.sh (Makeflow, with Work Queue on machines without a shared disk, or over Slurm, SGE,
/// HTCondor), slurm.sh (an array) and parallel.sh (GNU parallel on one machine); progress.sh, which says how many parts
/// are made and how long the rest takes. Each goes on after a crash. Of makeflow.sh and parallel.sh one runs at a time,
/// and a second one says so; both fail where there is no result at the end. A part that ends with 4, as its machine
/// gives other numbers, ends the worker that would draw the next one.
[[nodiscard]] std::vector<WorkflowFile> workflow_files(const Workflow& workflow);

/// "0003" of 3: what a folder of a part is called, so that a shell lists them in order.
[[nodiscard]] std::string part_folder(std::size_t number);

}  // namespace coilwright::exports
