"""Films of a finger with tags for tests: rendered by render_film, encoded by FFmpeg, read by `coilwright track`."""

import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from program import PROGRAM, ProgramTest, run

RENDER = os.environ["RENDER_FILM"]


def require_films():
    """Ends the test as skipped where films can be neither made nor read."""
    module = pathlib.Path(PROGRAM).with_name("libcoilwright_opencv.so")
    if not module.exists() or not shutil.which("ffmpeg"):
        print("needs OpenCV and ffmpeg")
        sys.exit(77)


def ffmpeg(*arguments, cwd):
    subprocess.run(["ffmpeg", "-v", "error", "-y", *map(str, arguments)], cwd=cwd, check=True)


def damped_step(time, start, angle, rate=25.0, decay=6.0):
    """Degrees; a second-order system that is let go at `start`."""
    since = max(0.0, time - start)
    wave = math.cos(rate * since) + decay / rate * math.sin(rate * since)
    return angle * (1.0 - math.exp(-decay * since) * wave)


class FilmTest(ProgramTest):
    def render(self, film, scene, motion):
        """`motion`: rows of time and one angle (bending) or two (joints), in degrees; or the name of a CSV."""
        if not isinstance(motion, str):
            names = "time_s,theta1_deg,theta2_deg" if len(motion[0]) == 3 else "time_s,bending_angle_deg"
            self.write("motion.csv", "\n".join([names, *(",".join(f"{x:.9g}" for x in row) for row in motion)]) + "\n")
            motion = "motion.csv"
        self.write("scene.json", json.dumps(scene))
        subprocess.run([RENDER, "scene.json", motion, film], cwd=self.folder, check=True)

    def track(self, *arguments):
        result = run("track", *arguments, "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def numbers(self, name):
        return [{key: float(value) for key, value in row.items()} for row in self.table(name)]


def main():
    require_films()
    unittest.main()
