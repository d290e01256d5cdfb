#!/usr/bin/env python3
"""Measures what a workflow of `coilwright distribute` costs beside the run on one machine, and works out from that how
many machines one master keeps busy.

    scripts/many_machines.py PROGRAM [--part-s 60] [--parts 4] [--tasks 100 400 1600]

Needs makeflow and work_queue_worker (Debian: coop-computing-tools). Prints the efficiency of two workers against
`--threads 2`, the time of the master for a task as the number of tasks grows, and, from these and the time of a design, a
table for 10^6 to 10^9 designs: a simulation of the queue, in which the master serves one worker after the other.
"""

import argparse
import heapq
import json
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "cli"))
import engine

WORKERS = (2, 100, 500, 1000, 2000, 4000)
LENGTHS = (60, 300, 600)  # s of a part


def write_study(folder, designs):
    """A grid of about so many designs of the finger."""
    shutil.copy(ROOT / "configs" / "actuators" / "paper_finger.json", folder / "finger.json")
    study = {"format": "study/1", "name": "grid", "actuator": "finger.json",
             "operating_point": {"share_of_current_limit": 0.9, "duty": 0.5},
             "variables": {"turns_radial": {"lower": 10, "upper": 17},
                           "gap_mm": {"lower": 0.7, "upper": 1.6, "step": 0.9 / max(1, designs // 8 - 1)}},
             "objectives": [{"maximise": "peak_bending_speed_deg_s"}],
             "constraints": [{"quantity": "mass_g", "at_most": 66}]}
    (folder / "study.json").write_text(json.dumps(study))


def timed(program, *arguments, cwd):
    """Wall time and time of processors, s, and what was printed."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    done = subprocess.run([program, *map(str, arguments)], cwd=cwd, check=True, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return time.monotonic() - begin, used, done.stdout


def sweep(program, folder, threads):
    wall, used, text = timed(program, "sweep", "study.json", "--out", f"whole{threads}", "--threads", threads, "--keep", "best",
                             "--quiet", "--json", cwd=folder)
    return wall, used, json.loads(text)["designs"]


def design_seconds(program):
    """Time of a processor for one design, s."""
    with tempfile.TemporaryDirectory() as name:
        write_study(pathlib.Path(name), 16000)  # the start of the program counts for little
        _, used, designs = sweep(program, pathlib.Path(name), 1)
        return used / designs


def workflow_seconds(folder):
    """Wall time, and time of a processor that the master took, s."""
    begin, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    with engine.Engine(folder) as running:
        assert running.wait() == 0, (folder / "engine.log").read_text()[-2000:]
        after = resource.getrusage(resource.RUSAGE_CHILDREN)  # of processes that have ended: the master alone
        return time.monotonic() - begin, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def efficiency(program, part_seconds, parts, design):
    """Wall time of `--threads 2` over that of two workers, first and last on one machine, from an empty folder to the
    merged result."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_study(folder, int(part_seconds * parts / design))
        subprocess.run([program, "distribute", "study.json", "--parts", str(parts), "--out", "work", "--options", "--keep best"],
                       cwd=folder, check=True, stdout=subprocess.DEVNULL)
        alone, _, designs = sweep(program, folder, 2)
        together, _ = workflow_seconds(folder / "work")
        print(f"{designs} designs in {parts} parts of {design * designs / parts:.0f} s: {alone:.1f} s with --threads 2, "
              f"{together:.1f} s with two workers: efficiency {alone / together:.3f}", flush=True)


def dispatch_seconds(tasks):
    """Wall time for each of so many tasks that do nothing, and what of it the master's processor worked, s."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        rules = "".join(f"out/{i}: in\n\tmkdir -p out && cp in out/{i}\n\n" for i in range(tasks))
        (folder / "in").write_text("x")
        (folder / "makeflow.sh").write_text('exec makeflow "$@" workflow.makeflow\n')
        (folder / "workflow.makeflow").write_text(f"CORES=1\nMEMORY=100\nDISK=10\n{rules}")
        return [seconds / tasks for seconds in workflow_seconds(folder)]


def line_through(points):
    """Least squares: what a task costs, and what each further one adds to it."""
    n = len(points)
    mean_x, mean_y = sum(x for x, _ in points) / n, sum(y for _, y in points) / n
    spread = sum((x - mean_x) ** 2 for x, _ in points)
    slope = sum((x - mean_x) * (y - mean_y) for x, y in points) / spread if spread else 0.0
    return mean_y - slope * mean_x, max(slope, 0.0)


def simulated(parts, length, workers, dispatch):
    """When the last of so many parts of a length is done, s: a worker that is free waits for the master, who needs
    `dispatch` for each."""
    free = [0.0] * min(workers, parts)
    master = end = 0.0
    for _ in range(parts):
        master = max(master, free[0]) + dispatch
        end = max(end, master + length)
        heapq.heapreplace(free, master + length)
    return end


def print_model(design, points):
    base, growth = line_through(points)
    print(f"\nA design takes {1000 * design:.3f} ms of a processor, a task {1000 * base:.1f} ms of the master and {1e6 * growth:.2f} us "
          "more for each other task.\n")
    print("designs  part_s   parts  dispatch_ms  saturates_at_workers  most_designs_per_s  " + "  ".join(f"{w:>7} w" for w in WORKERS))
    for designs in (10**6, 10**7, 10**8, 10**9):
        for length in LENGTHS:
            parts = max(1, round(designs * design / length))
            each = base + growth * parts
            ends = [simulated(parts, length, workers, each) for workers in WORKERS]
            print(f"{designs:>7.0e}  {length:>6}  {parts:>6}  {1000 * each:>11.1f}  {length / each:>20.0f}  {designs / parts / each:>18.0f}  "
                  + "  ".join(f"{end:>7.0f} s" for end in ends), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda text: str(pathlib.Path(text).resolve()))
    parser.add_argument("--part-s", type=float, default=60, help="seconds of a processor for a part (default 60)")
    parser.add_argument("--parts", type=int, default=4, help="how many (default 4; 0: leave the efficiency out)")
    parser.add_argument("--tasks", type=int, nargs="+", default=[100, 400, 1600], help="numbers of empty tasks to time")
    options = parser.parse_args()
    if not engine.is_installed():
        sys.exit("many_machines: makeflow and work_queue_worker are needed (Debian: coop-computing-tools)")
    design = design_seconds(options.program)
    if options.parts:
        efficiency(options.program, options.part_s, options.parts, design)
    points = []
    for tasks in options.tasks:
        wall, used = dispatch_seconds(tasks)
        print(f"{tasks} tasks that do nothing: {1000 * wall:.1f} ms each, {1000 * used:.2f} ms of the master's processor", flush=True)
        points.append((tasks, wall))
    print_model(design, points)


if __name__ == "__main__":
    main()
