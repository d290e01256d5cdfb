#include "coilwright/exports/workflow.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace coilwright::exports {
namespace {

// The libraries beside the program, where there are any, before those of the machine.
constexpr const char* with_libraries = "LD_LIBRARY_PATH=lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}";

std::string part_script(const Workflow& workflow) {
  return fmt::format(R"(#!/bin/sh
# Makes part $1 of {}. Begun again, it goes on.
export {}
exec ./{} $(sed -n "$1p" arguments.txt)
)",
                     workflow.arguments.size(), with_libraries, workflow.program);
}

std::string merge_script(const Workflow& workflow) {
  return fmt::format(R"(#!/bin/sh
# Puts the parts together. No design that keeps all limits (exit code 3) is an answer, too.
export {}
{} || test $? -eq 3
)",
                     with_libraries, workflow.merge);
}

// A rule a part. Work Queue gives each one core of a worker, and lets others run beside it.
std::string makeflow(const Workflow& workflow) {
  std::string text = fmt::format("CORES=1\nMEMORY=500\nDISK=500\nSHARED=part.sh arguments.txt {} {}\n\n",
                                 workflow.program, fmt::join(workflow.inputs, " "));
  std::string all;
  for (std::size_t i = 0; i < workflow.outputs.size(); ++i) {
    const std::string outputs = fmt::format("{}", fmt::join(workflow.outputs[i], " "));
    text += fmt::format("{}: $(SHARED)\n\tsh part.sh {}\n\n", outputs, i + 1);
    all += " " + outputs;
  }
  return text + fmt::format("{}: merge.sh {}{}\n\tLOCAL sh merge.sh\n", workflow.result, workflow.program, all);
}

std::string slurm(const Workflow& workflow) {
  return fmt::format(R"(#!/bin/sh
#SBATCH --job-name={}
#SBATCH --array=1-{}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --output=slurm-%a.log
exec sh part.sh "$SLURM_ARRAY_TASK_ID"
)",
                     workflow.program, workflow.arguments.size());
}

// Of whoever gives out the parts of a folder: two at once would give each away twice, and write over each other's log.
// What a killed one has started (Debian's makeflow: a daemon of Open MPI) ends a moment after it.
constexpr const char* alone =
    "exec 9>> parts.lock\n"
    "flock -w 5 9 || { echo \"$0: another run gives out the parts of this folder: wait for its end\" >&2; exit 1; }\n";

std::string makeflow_script() {
  return fmt::format(R"(#!/bin/sh
# Makeflow, one at a time, with the options of this call: -T wq -p 9123 -r 3. Begun again, it makes what is missing.
{}exec makeflow "$@" workflow.makeflow
)",
                     alone);
}

std::string parallel(const Workflow& workflow) {
  return fmt::format(R"(#!/bin/sh
# On this machine, as many parts at once as it has cores. Begun again, it makes what is missing.
set -e
{}seq {} | parallel --will-cite --joblog parallel.log --resume-failed sh part.sh
sh merge.sh
)",
                     alone, workflow.arguments.size());
}

}  // namespace

std::vector<WorkflowFile> workflow_files(const Workflow& workflow) {
  return {{"arguments.txt", fmt::format("{}\n", fmt::join(workflow.arguments, "\n"))},
          {"part.sh", part_script(workflow)},
          {"merge.sh", merge_script(workflow)},
          {"workflow.makeflow", makeflow(workflow)},
          {"makeflow.sh", makeflow_script()},
          {"slurm.sh", slurm(workflow)},
          {"parallel.sh", parallel(workflow)}};
}

std::string part_folder(std::size_t number) {
  return fmt::format("{:04}", number);
}

}  // namespace coilwright::exports
