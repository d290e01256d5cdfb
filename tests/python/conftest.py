import os
import pathlib
import subprocess

import pytest

import coilwright as cw

ROOT = pathlib.Path(__file__).resolve().parents[2]


def pytest_configure(config):
    config.addinivalue_line("markers", "long: half a minute or more; `scripts/test.sh` leaves it out but for --long")


@pytest.fixture
def finger() -> cw.Actuator:
    return cw.Actuator.load(ROOT / "configs/actuators/paper_finger.json")


@pytest.fixture
def program():
    """Runs the program, and gives what it prints."""
    def run(*words) -> str:
        done = subprocess.run([os.environ["COILWRIGHT"], *map(str, words)], cwd=ROOT, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout
    return run
