"""What tests of archives have in common: runs that are killed, and what they left."""

import contextlib
import pathlib
import shutil
import signal
import sqlite3
import struct
import subprocess
import tempfile
import time

from program import PROGRAM

ARCHIVE = "archive.sqlite"


def designs_of(folder, table="designs"):
    """The designs recorded of a table of them, in their order, each as it stands; read from a copy, so that the archive stays untouched."""
    with tempfile.TemporaryDirectory() as copy:
        for path in pathlib.Path(folder).glob(ARCHIVE + "*"):
            shutil.copy(path, copy)
        if not (pathlib.Path(copy) / ARCHIVE).exists():
            return []
        database = sqlite3.connect(pathlib.Path(copy) / ARCHIVE)
        rows = database.execute(f"SELECT * FROM {table} ORDER BY id").fetchall()
        names = [each[1] for each in database.execute(f"PRAGMA table_info({table})")]
        database.close()
    # The order of the search is known once a run has ended, and then written to earlier designs too.
    moving = {names.index("number"), names.index("checksum")}
    return [tuple(value for i, value in enumerate(row) if i not in moving) for row in rows]


CRC_TABLE = []
for _byte in range(256):
    _crc = _byte
    for _ in range(8):
        _crc = _crc >> 1 ^ (0xC96C5795D7870F42 if _crc & 1 else 0)  # CRC-64/XZ, reflected
    CRC_TABLE.append(_crc)


def checksum(*values):
    """The checksum of a row as docs/formats-results.md describes it, signed as SQLite keeps it."""
    data = b""
    for value in values:
        if value is None:
            data += b"\5"
        elif isinstance(value, int):
            data += b"\1" + struct.pack("<q", value)
        elif isinstance(value, float):
            data += b"\2" + struct.pack("<d", value)
        else:
            text = value.encode() if isinstance(value, str) else value
            data += (b"\3" if isinstance(value, str) else b"\4") + struct.pack("<q", len(text)) + text
    crc = 0xFFFFFFFFFFFFFFFF
    for byte in data:
        crc = crc >> 8 ^ CRC_TABLE[(crc ^ byte) & 255]
    return struct.unpack("<q", struct.pack("<Q", crc ^ 0xFFFFFFFFFFFFFFFF))[0]


def forge(folder, sql):
    """Changes an archive as a program would that knows its checksums."""
    with contextlib.closing(sqlite3.connect(pathlib.Path(folder) / ARCHIVE)) as database, database:
        database.execute(sql)
        for (table,) in database.execute("SELECT name FROM sqlite_schema WHERE type = 'table'").fetchall():
            for row in database.execute(f"SELECT rowid, * FROM {table}").fetchall():
                values = row[:-1] if table == "study" else row[1:-1]
                nested = ()
                for begin in range(0, len(values), 99):
                    nested = (checksum(*nested, *values[begin:begin + 99]),)
                database.execute(f"UPDATE {table} SET checksum = ? WHERE rowid = ?", (*nested, row[0]))


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


def stop_with_designs(test, process, folder, count, table="designs"):
    """Returns when so many designs are recorded, with the process stopped: it goes on only in slices between two looks, so
    that a run of a second does not end before it is interrupted, however late this program is woken."""
    deadline = time.monotonic() + 60
    process.send_signal(signal.SIGSTOP)
    while len(designs_of(folder, table)) < count:
        test.assertLess(time.monotonic(), deadline)
        test.assertIsNone(process.poll())
        process.send_signal(signal.SIGCONT)
        time.sleep(0.01)
        process.send_signal(signal.SIGSTOP)
