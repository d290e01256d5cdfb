"""Makes results by the built program, their pages, and opens them and the bench in Chromium, of which a name behind it gets
the picture in docs/figures. Ends with 77, which is shown as skipped,
without Node, npm and Chromium, or where the program or the test lacks what npm installs."""

import csv
import hashlib
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent.parent
PROGRAM = os.environ["COILWRIGHT"]
FOLDER = pathlib.Path(os.environ["BROWSER_TEST_FOLDER"])


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def tools():
    found = {name: shutil.which(name) for name in ("node", "npm")}
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    for name, path in {**found, "Chromium": chromium}.items():
        if not path:
            skip(f"{name} is not installed")
    return found["node"], found["npm"], chromium


def install(npm):
    """playwright-core beside copies of the scripts, once for a lock file."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for file in (*HERE.glob("*.mjs"), *HERE.glob("package*.json"), HERE / ".npmrc"):
        shutil.copy(file, FOLDER)
    digest = hashlib.sha256((HERE / "package-lock.json").read_bytes()).hexdigest()
    stamp = FOLDER / "stamp.txt"
    if stamp.exists() and stamp.read_text() == digest:
        return
    done = subprocess.run([npm, "ci", "--no-audit", "--no-fund", "--ignore-scripts"], cwd=FOLDER, check=False,
                          capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        skip("npm cannot install playwright-core: " + done.stderr.strip().partition("\n")[0])
    stamp.write_text(digest)


def run(*arguments, codes=(0,)):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=300)
    if done.returncode == 2 and "built without Vega" in done.stderr:
        skip("the program was built without Vega")
    if done.returncode not in codes:
        sys.exit(f"{' '.join(map(str, arguments))}: {done.returncode}: {done.stderr}")


def small_study(name, folder, **changes):
    study = json.loads((ROOT / "configs/studies" / f"{name}.json").read_text())
    study.update(changes)
    study["actuator"] = str((ROOT / "configs/studies" / study["actuator"]).resolve())
    file = folder / f"{name}.json"
    file.write_text(json.dumps(study))
    return file


def many(folder, source, count):
    """A front of `count` rows: those of a small one, which the result names, and mixtures of two of them."""
    target = folder / "many"
    target.mkdir()
    with open(source / "front.csv", newline="") as file:
        names, *rows = list(csv.reader(file))
    result = json.loads((source / "result.json").read_text())
    draw = random.Random(1)
    with open(target / "front.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(names)
        writer.writerows(rows)
        for _ in range(count - len(rows)):
            one, other, share = draw.choice(rows), draw.choice(rows), draw.random()
            writer.writerow([repr(share * float(a) + (1 - share) * float(b)) if a and b else "" for a, b in zip(one, other)])
    for name in ("evaluations.csv", "convergence.csv"):
        shutil.copy(source / name, target)
    result["front_size"] = count
    (target / "result.json").write_text(json.dumps(result))
    return target


def main():
    node, npm, chromium = tools()
    install(npm)
    environment = {**os.environ, "CHROMIUM": chromium}
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        sizing = small_study("fastest_finger", folder)
        run("size", sizing, "--out", folder / "size", "--max-evaluations", 120, "--quiet", "--report", codes=(0, 3))
        front = small_study("speed_against_grip", folder)
        run("pareto", front, "--out", folder / "pareto", "--max-evaluations", 600, "--quiet", "--report", codes=(0, 3))
        three = small_study("speed_grip_mass", folder)
        run("pareto", three, "--out", folder / "three", "--max-evaluations", 200, "--quiet", "--report", codes=(0, 3))
        run("init", "dataset", "--out", folder / "records")
        run("diagnose", folder / "records", "--out", folder / "diagnose", "--quiet", "--report")
        finger = ROOT / "configs/actuators/finger.json"
        run("evaluate", finger, "--current-A", 1, "--report", folder / "evaluate.html")
        run("validate", "--report", folder / "validate.html")
        grid = small_study("configurations", folder)
        run("sweep", grid, "--out", folder / "sweep", "--quiet", "--report")
        run("report", many(folder, folder / "pareto", 20000))
        for script, page in (("sizing_test.mjs", "size"), ("front_test.mjs", "pareto"),
                             ("three_test.mjs", "three"), ("many_test.mjs", "many"), ("diagnosis_test.mjs", "diagnose")):
            subprocess.run([node, FOLDER / script, folder / page / "report.html", PROGRAM], env=environment, check=True,
                           timeout=300)
        subprocess.run([node, FOLDER / "bench_test.mjs", PROGRAM, finger, folder / "pareto", folder / "diagnose", *sys.argv[1:2]], env=environment,
                       check=True, timeout=300)
        for page in ("sweep/report.html", "evaluate.html", "validate.html"):
            subprocess.run([node, FOLDER / "plain_test.mjs", folder / page], env=environment, check=True, timeout=300)


if __name__ == "__main__":
    main()
