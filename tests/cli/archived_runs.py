"""What tests of archives have in common: runs that are killed, and what they left."""

import pathlib
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import time

from program import PROGRAM

ARCHIVE = "archive.sqlite"


def designs_of(folder):
    """The designs recorded, in their order, each as it stands; read from a copy, so that the archive stays untouched."""
    with tempfile.TemporaryDirectory() as copy:
        for path in pathlib.Path(folder).glob(ARCHIVE + "*"):
            shutil.copy(path, copy)
        if not (pathlib.Path(copy) / ARCHIVE).exists():
            return []
        database = sqlite3.connect(pathlib.Path(copy) / ARCHIVE)
        rows = database.execute("SELECT * FROM designs ORDER BY id").fetchall()
        names = [each[1] for each in database.execute("PRAGMA table_info(designs)")]
        database.close()
    # The order of the search is known once a run has ended, and then written to earlier designs too.
    number = names.index("number")
    return [row[:number] + row[number + 1:] for row in rows]


def results_of(folder):
    """Every result but the archive, which says when and how fast."""
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()
            if not path.name.startswith(ARCHIVE)}


def start(*arguments, cwd, **options):
    return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            encoding="utf-8", **options)


def end(process):
    """Whatever became of it."""
    process.kill()
    process.wait()
    for pipe in (process.stdout, process.stderr):
        pipe.close()


def stop_with_designs(test, process, folder, count):
    """Returns when so many designs are recorded, with the process stopped: it goes on only in slices between two looks, so
    that a run of a second does not end before it is interrupted, however late this program is woken."""
    deadline = time.monotonic() + 60
    process.send_signal(signal.SIGSTOP)
    while len(designs_of(folder)) < count:
        test.assertLess(time.monotonic(), deadline)
        test.assertIsNone(process.poll())
        process.send_signal(signal.SIGCONT)
        time.sleep(0.01)
        process.send_signal(signal.SIGSTOP)
