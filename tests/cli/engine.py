"""Workflows of `coilwright distribute` under the engine that users have: Makeflow as the master, Work Queue's workers, on
loopback, and any of them killed at random. The engine is called as a program."""

import os
import pathlib
import random
import shutil
import signal
import subprocess
import tempfile
import time

HANGS = 600  # s


def is_installed():
    return all(shutil.which(name) for name in ("makeflow", "work_queue_worker"))


class Engine:
    """A master in the folder of a workflow and workers with one core each. Use it in a `with`, which ends them all."""

    def __init__(self, folder, workers=2, log=None):
        self.folder = pathlib.Path(folder)
        self.log = open(log or self.folder / "engine.log", "ab")
        self.places = tempfile.TemporaryDirectory()
        self.port = None
        self.master = self.start_master()
        self.workers = [self.start_worker(number) for number in range(workers)]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in (self.master, *self.workers):
            self.kill(process)
        self.log.close()
        self.places.cleanup()

    def start(self, *arguments, **variables):
        # A group of its own: a worker's part ends with it, as on a machine that is switched off.
        return subprocess.Popen(list(map(str, arguments)), cwd=self.folder, stdout=self.log, stderr=self.log,
                                stdin=subprocess.DEVNULL, start_new_session=True, env={**os.environ, **variables})

    def start_master(self):
        port_file = pathlib.Path(self.places.name) / "port"
        port = ["-p", self.port] if self.port else ["-Z", port_file]
        master = self.start("sh", "makeflow.sh", "-T", "wq", *port, "-r", 3)
        deadline = time.monotonic() + HANGS
        while not self.port:
            assert master.poll() is None and time.monotonic() < deadline, "the master ended at once"
            time.sleep(0.05)
            self.port = port_file.read_text().strip() if port_file.exists() else None
        return master

    def start_worker(self, number, **variables):
        place = pathlib.Path(self.places.name) / f"worker{number}_{time.monotonic_ns()}"
        place.mkdir()
        return self.start("work_queue_worker", "--cores", 1, "--memory", 1000, "--disk", 2000, "-t", HANGS, "-s", place,
                          "--single-shot", "-i", 1, "-b", 1, "127.0.0.1", self.port, **variables)

    def kill(self, process):
        """By its own number, and what it started: nothing else is touched."""
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()

    def kill_and_restart(self, which):
        """`which` is 0 for the master, else a worker. False where the master had ended before."""
        if self.master.poll() is not None:
            return False
        if which == 0:
            self.kill(self.master)
            self.master = self.start_master()
        else:
            self.kill(self.workers[which - 1])
            self.workers[which - 1] = self.start_worker(which - 1)
        return True

    def wait(self):
        """Till the master ends; workers that lost it are started again. Its exit code."""
        deadline = time.monotonic() + HANGS
        while self.master.poll() is None:
            assert time.monotonic() < deadline, "the workflow does not end"
            for number, worker in enumerate(self.workers):
                if worker.poll() is not None:
                    self.workers[number] = self.start_worker(number)
            time.sleep(0.05)
        return self.master.returncode


def run_with_kills(folder, kills, duration, seed):
    """Runs a workflow of about `duration` s to its end with so many kills at random moments of random processes; the first
    kill is the master's at every third seed. Returns which were killed."""
    dice = random.Random(seed)
    killed = []
    with Engine(folder) as engine:
        for _ in range(kills):
            time.sleep(dice.uniform(0.1, 0.9) * duration / kills)
            which = 0 if seed % 3 == 0 and not killed else dice.randint(0, 2)
            if engine.kill_and_restart(which):
                killed.append(("master", "worker 1", "worker 2")[which])
        code = engine.wait()
    assert code == 0, (folder / "engine.log").read_text()[-2000:]
    return killed
