"""Bias, noise, stated deviation and speed of `coilwright track` on rendered films of 640 by 480 px with tags of 40 px.

Prints a table. Errors are those of the tip's angle, after the film's own mean, at the middle of each exposure.
"""

import json
import math
import time
import unittest

import filming
from filming import FilmTest, damped_step, run

BASE = {"width": 640, "height": 480, "px_per_mm": 5.0, "rate": 240, "duration": 0.7, "exposure": 1e-3,
        "segment_tag": False}
# What differs; then the largest bias and noise, degrees. The issue asks for 0.05 and 0.1 of the compressed film.
FILMS = {
    "x264, crf 18": ({"crf": 18}, 0.05, 0.1),
    "x264, crf 23": ({"crf": 23}, 0.1, 0.2),
    "low light": ({"crf": 18, "white": 70, "noise": 4.0}, 0.1, 0.2),
    "rolling shutter of 12 ms": ({"crf": 18, "readout": 0.012}, 0.1, 0.2),
    "exposure of 4 ms": ({"crf": 18, "exposure": 4e-3}, 0.1, 0.2),
    "8 degrees off the normal": ({"crf": 18, "tilt": [0.05, 0.13]}, 0.1, 0.2),
    "60 Hz": ({"crf": 18, "rate": 60, "duration": 1.2}, 0.05, 0.1),
    "crf 6": ({"crf": 6}, 0.05, 0.1),
    "much noise": ({"crf": 12, "noise": 10.0}, 0.05, 0.1),
    "tags of 26 px": ({"crf": 16, "px_per_mm": 3.25}, 0.1, 0.2),
    "tags of 72 px": ({"crf": 20, "px_per_mm": 9.0, "width": 880, "height": 860, "duration": 0.35}, 0.05, 0.1),
    "out of focus": ({"crf": 14, "optics": 1.2}, 0.1, 0.2),
}


def motion(t):
    return 4 + damped_step(t, 0.1, 40, rate=22, decay=4)


def true_angle(time_s, exposure):
    steps = 8
    return sum(motion(time_s + exposure * ((i + 0.5) / steps - 0.5)) for i in range(steps)) / steps


class Accuracy(FilmTest):
    def errors(self, changes):
        scene = {**BASE, **changes}
        self.render("film.mp4", scene, [(t * 5e-4, motion(t * 5e-4)) for t in range(0, 3000)])
        width, height = scene["width"], scene["height"]
        self.write("lens.json", json.dumps({"format": "lens/1", "width_px": width, "height_px": height, "rms_px": 0,
                                            "focal_px": [600, 600], "centre_px": [(width - 1) / 2, (height - 1) / 2],
                                            "distortion": [0, 0, 0, 0, 0]}))
        begin = time.perf_counter()
        answer = self.track("film.mp4", "--out", "data", "--force", "--lens", "lens.json", "--opens",
                            "counterclockwise")["films"][0]
        seconds = time.perf_counter() - begin
        rows = self.numbers("data/film.csv")
        errors = [row["bending_angle_deg"] - true_angle(row["time_s"], scene["exposure"]) for row in rows]
        bias = sum(errors) / len(errors)
        noise = math.sqrt(sum((error - bias) ** 2 for error in errors) / len(errors))
        stated = math.sqrt(sum(row["sigma_deg"] ** 2 for row in rows) / len(rows))
        return bias, noise, stated, answer, answer["pictures"] / seconds

    def test_errors_are_small_and_stated(self):
        print(f"\n{'film':26s} {'bias':>7s} {'noise':>7s} {'stated':>7s} ratio {'read':>9s} exposure readout  films/s")
        for name, (changes, most_bias, most_noise) in FILMS.items():
            with self.subTest(name):
                bias, noise, stated, answer, rate = self.errors(changes)
                print(f"{name:26s} {bias:7.3f} {noise:7.3f} {stated:7.3f} {stated / noise:5.2f} "
                      f"{answer['read']:4d}/{answer['pictures']:4d} {answer['exposure_s'] * 1e3:5.2f} ms "
                      f"{answer['readout_s'] * 1e3:5.2f} ms {rate:6.1f} frames/s", flush=True)
                self.assertLess(abs(bias), most_bias)
                self.assertLess(noise, most_noise)
                self.assertGreater(stated / noise, 0.85)  # of one film: its error is known to a tenth
                self.assertLess(stated / noise, 1.3)
                self.assertLess(abs(answer["readout_s"] - changes.get("readout", 0.0)), 0.3e-3)

    def test_speed_of_720p(self):
        self.render("film.mp4", {**BASE, "width": 1280, "height": 720, "crf": 18, "duration": 0.4},
                    [(t * 5e-4, motion(t * 5e-4)) for t in range(0, 1000)])
        seconds = time.perf_counter()
        answer = self.track("film.mp4", "--out", "data")
        seconds = time.perf_counter() - seconds
        print(f"\n720p: {answer['films'][0]['pictures'] / seconds:.0f} frames a second, the program's start included")


if __name__ == "__main__":
    filming.main()
