#!/usr/bin/env python3
"""Which friction gives the paper's crawling robot its 8.3 mm/s? usage: crawl.py PATH/TO/coilwright

Everything is asked of `coilwright crawl` with the paper's finger: pairs of friction coefficients with that speed, by
bisection over the backward one; then speed over frequency, duty, the cell's voltage and the length of the payload, which
the paper does not give. Takes two minutes.
"""

import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FINGER = ROOT / "configs/actuators/paper_finger.json"
SPEED = 8.3  # mm/s, the paper's

PROGRAM = sys.argv[1]


def crawl(forwards, backwards, **options):
    words = [f"--{name.replace('_', '-')}={value}" for name, value in options.items()]
    result = subprocess.run([PROGRAM, "crawl", FINGER, f"--friction-forwards={forwards}",
                             f"--friction-backwards={backwards}", "--json", *words],
                            check=True, stdout=subprocess.PIPE, encoding="utf-8")
    return json.loads(result.stdout)


def speed(forwards, backwards, **options):
    return crawl(forwards, backwards, **options)["speed_mm_s"]


def backwards_for(forwards, wanted, **options):
    """The least backward coefficient from 0.05 to 3 at which the speed rises to `wanted`, or nothing, and the greatest speed.

    Speed over the coefficient is no simple curve: it is looked at in 20 places before it is bisected.
    """
    places = [0.05 * 60.0 ** (i / 19) for i in range(20)]
    speeds = [speed(forwards, place, **options) for place in places]
    for i in range(1, len(places)):
        if speeds[i - 1] < wanted <= speeds[i]:
            low, high = places[i - 1], places[i]
            for _ in range(9):
                middle = 0.5 * (low + high)
                if speed(forwards, middle, **options) < wanted:
                    low = middle
                else:
                    high = middle
            return 0.5 * (low + high), max(speeds)
    return None, max(speeds)


def pairs(title, **options):
    print(f"\n{title}\nforwards  backwards  ratio  with equal friction, mm/s  greatest, mm/s")
    for forwards in (0.1, 0.2, 0.3, 0.4, 0.6, 0.8):
        found, greatest = backwards_for(forwards, SPEED, **options)
        words = f"{'none':>9}  {'':5}" if found is None else f"{found:9.3f}  {found / forwards:5.2f}"
        print(f"{forwards:8.2f}  {words}  {speed(forwards, forwards, **options):25.2f}  {greatest:14.2f}")


def over(title, name, values, **options):
    print(f"\n{title}\n{name:>20}  speed mm/s  scatter mm/s  power W  distance per charge m")
    for value in values:
        answer = crawl(0.3, 0.6, **{name: value}, **options)
        print(f"{value:20g}  {answer['speed_mm_s']:10.2f}  {answer['speed_scatter_mm_s']:12.2f}"
              f"  {answer['power_W']:7.3f}  {answer['distance_per_charge_m']:21.1f}")


def main():
    for duty in (0.5, 0.15, 0.2, 0.9):
        pairs(f"Friction with {SPEED} mm/s at 10 Hz, duty {duty}", duty=duty)
    over("Friction 0.3 and 0.6, over the frequency", "frequency_Hz", (1, 2, 3, 5, 7, 8, 9, 10, 11, 12, 13, 15, 20, 30))
    over("Friction 0.3 and 0.6, over the duty", "duty", (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9))
    over("Friction 0.3 and 0.6, over the cell's voltage", "cell_voltage_V", (3.4, 3.7, 4.0, 4.2))
    over("Friction 0.3 and 0.6, over the payload's length", "payload_length_mm", (15, 20, 25, 30, 35, 40, 50))


if __name__ == "__main__":
    main()
