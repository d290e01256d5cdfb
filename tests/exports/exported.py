"""Actuators that the tests of exports share, and their export."""

import json
import pathlib
import sys

from program import CONFIGS, run

FINGER = CONFIGS / "actuators" / "finger.json"
PAPER_FINGER = CONFIGS / "actuators" / "paper_finger.json"


def skip_without(missing: list[str]) -> None:
    """Ends with 77, which ctest shows as skipped."""
    if missing:
        print(f"skipped: {' and '.join(missing)} not installed")
        sys.exit(77)


def changed_finger(folder: pathlib.Path, **changes) -> pathlib.Path:
    """The finger with other members, each replaced or, where both are objects, changed."""
    finger = json.loads(FINGER.read_text())
    for key, value in changes.items():
        finger[key] = {**finger[key], **value} if isinstance(value, dict) and key in finger else value
    if "layout" in changes:
        del finger["configuration"]
    path = folder / "changed.json"
    path.write_text(json.dumps(finger))
    return path


def export(actuator, kind, folder, *more):
    """What the program wrote into `folder`, and what it says is left out."""
    result = run("export", actuator, "--as", kind, "--out", folder, "--force", *more)
    assert result.returncode == 0, result.stderr
    return folder, result.stderr


def evaluated(actuator, current):
    result = run("evaluate", actuator, "--current-A", current, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def linear(actuator, current):
    result = run("linearise", actuator, "--current-A", current, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)
