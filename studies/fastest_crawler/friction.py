#!/usr/bin/env python3
"""How fast the robot of fastest_crawler is on other ground: its friction was assumed.

usage: friction.py PATH/TO/coilwright results/reference/fastest_crawler
"""

import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FORWARDS = (0.1, 0.2, 0.3, 0.4, 0.6, 0.8)
RATIOS = (1.0, 1.25, 1.5, 2.0, 3.0)
PROTOTYPE = {"frequency_Hz": 10.0, "duty": 0.5}


def speed(program, actuator, drive, forwards, backwards) -> float:
    """mm/s, as `crawl` prints it with its own, finer timing."""
    options = {"friction-forwards": forwards, "friction-backwards": backwards, "frequency-Hz": drive["frequency_Hz"],
               "duty": drive["duty"]}
    words = [str(word) for name, value in options.items() for word in (f"--{name}", value)]
    answer = subprocess.run([program, "crawl", actuator, *words, "--json"], check=True, capture_output=True, text=True)
    return json.loads(answer.stdout)["speed_mm_s"]


def table(program, actuator, drive) -> None:
    print("forwards  " + "".join(f"{f'x {ratio:g}':>9}" for ratio in RATIOS))
    for forwards in FORWARDS:
        row = [speed(program, actuator, drive, forwards, round(forwards * ratio, 3)) for ratio in RATIOS]
        print(f"{forwards:<10}" + "".join(f"{value:9.1f}" for value in row))


def main() -> None:
    program, reference = sys.argv[1], pathlib.Path(sys.argv[2])
    variables = json.loads((reference / "result.json").read_text(encoding="utf-8"))["best"]["variables"]
    drive = {"frequency_Hz": variables["crawler_frequency_Hz"], "duty": variables["crawler_duty"]}
    print(f"Speed, mm/s, by friction forwards and what it is backwards: the robot found, {drive['frequency_Hz']:g} Hz, "
          f"duty {drive['duty']:g}")
    table(program, reference / "actuator.json", drive)
    print("\nThe prototype, 10 Hz, duty 0.5")
    table(program, ROOT / "configs/actuators/paper_finger.json", PROTOTYPE)


if __name__ == "__main__":
    main()
