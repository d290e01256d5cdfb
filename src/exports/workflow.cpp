#include "coilwright/exports/workflow.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace coilwright::exports {
namespace {

// The libraries beside the program, where there are any, before those of the machine.
constexpr const char* with_libraries = "LD_LIBRARY_PATH=lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}";

constexpr const char* made_parts = "find parts -mindepth 2 -maxdepth 2 -name part.json 2>/dev/null | wc -l";

// A machine whose figures differ refuses each part in a second, would draw most of them and use up their repetitions:
// its worker leaves, and Work Queue gives the part to another. Where there is none, as under Slurm, time passes.
std::string part_script(const Workflow& workflow) {
  return fmt::format(R"(#!/bin/sh
# Makes part $1 of {}. Begun again, it goes on.
export {}
./{} $(sed -n "$1p" arguments.txt)
status=$?
test $status -eq 4 || exit $status
process=$PPID
while test "$process" -gt 1; do
  case $(cat /proc/$process/comm) in
    work_queue_work*)
      echo "part.sh: this machine gives other numbers than the one that gathers the parts: its worker ends" \
        >> /proc/$process/fd/2
      for again in 1 2 3; do  # it misses a signal now and then
        kill $process 2>/dev/null || exit 4
        sleep 1
      done
      kill -9 $process
      exit 4 ;;
  esac
  process=$(sed 's/.*) . //; s/ .*//' /proc/$process/stat)
done
sleep 60
exit 4
)",
                     workflow.arguments.size(), with_libraries, workflow.program);
}

// How many parts are made, on each change, and how long the rest takes at the pace since it began.
std::string progress_script(const Workflow& workflow) {
  return fmt::format(R"(#!/bin/sh
# Says how many parts are made, until all are, or the process $1 has ended.
of={}
made() {{ {}; }}
first=$(made)
begin=$(date +%s)
told=
while :; do
  ended=
  test -z "$1" || kill -0 "$1" 2>/dev/null || ended=1
  now=$(made)
  if test "$now" != "$told"; then
    left=
    if test "$now" -gt "$first" && test "$now" -lt $of; then
      left=$(( ($(date +%s) - begin) * (of - now) / (now - first) ))
      if test $left -lt 120; then left=", about $left s left"; else left=", about $((left / 60)) min left"; fi
    fi
    echo "$now of $of parts are made$left"
    told=$now
  fi
  test "$now" -lt $of || exit 0
  test -z "$ended" || exit 0
  sleep 2
done
)",
                     workflow.arguments.size(), made_parts);
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
  std::string options;  // of two lines about one thing sbatch takes the last
  for (const std::string& each : workflow.slurm) options += fmt::format("#SBATCH {}\n", each);
  return fmt::format(R"(#!/bin/sh
#SBATCH --job-name={}
#SBATCH --array=1-{}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --mem=500M
#SBATCH --output=slurm-%a.log
{}exec sh part.sh "$SLURM_ARRAY_TASK_ID"
)",
                     workflow.program, workflow.arguments.size(), options);
}

// Of whoever gives out the parts of a folder: two at once would give each away twice, and write over each other's log.
// What a killed one has started (Debian's makeflow: a daemon of Open MPI) ends a moment after it.
constexpr const char* alone =
    "exec 9>> parts.lock\n"
    "flock -w 5 9 || { echo \"$0: another run gives out the parts of this folder: wait for its end\" >&2; exit 1; }\n";

// Makeflow ends with 0 where parts have failed. It is a child, which ends with this script however that is ended.
std::string makeflow_script(const Workflow& workflow) {
  return fmt::format(R"(#!/bin/sh
# Makeflow, one at a time, with the options of this call: -T wq -p 9123 -r 3. Begun again, it makes what is missing.
{}setpriv --pdeathsig TERM makeflow "$@" workflow.makeflow &
engine=$!
trap 'kill -TERM $engine' HUP INT TERM
sh progress.sh $engine >&2 9>&- &
progress=$!
wait $engine
status=$?
while kill -0 $engine 2>/dev/null; do
  wait $engine
  status=$?
done
wait $progress
test $status -eq 0 || exit $status
made=$({})
test "$made" -eq {} && test -s {} && exit 0
echo "$0: there is no result: $made of {} parts are made, and what stopped the rest stands above; begun again, this" \
  "makes what is missing" >&2
exit 1
)",
                     alone, made_parts, workflow.arguments.size(), workflow.result, workflow.arguments.size());
}

std::string parallel(const Workflow& workflow) {
  return fmt::format(R"(#!/bin/sh
# On this machine, as many parts at once as it has cores. Begun again, it makes what is missing.
set -e
{}sh progress.sh $$ >&2 9>&- &
seq {} | parallel --will-cite --joblog parallel.log --resume-failed sh part.sh
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
          {"makeflow.sh", makeflow_script(workflow)},
          {"progress.sh", progress_script(workflow)},
          {"slurm.sh", slurm(workflow)},
          {"parallel.sh", parallel(workflow)}};
}

std::string part_folder(std::size_t number) {
  return fmt::format("{:04}", number);
}

}  // namespace coilwright::exports
