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
# The pictures that were drawn of the scenes and motions of late, by their number: to draw one takes far longer than all else
# of a test, and most films show the same motion, each coded or cut in its own way.
DRAWN = {}
KEPT = 4


def require_films():
    """Ends the test as skipped where films can be neither made nor read."""
    module = pathlib.Path(PROGRAM).with_name("libcoilwright_opencv.so")
    if not module.exists() or not shutil.which("ffmpeg"):
        print("skipped: OpenCV (scripts/setup.sh films, then build again) or ffmpeg not installed")
        sys.exit(77)


def ffmpeg(*arguments, cwd):
    subprocess.run(["ffmpeg", "-v", "error", "-y", *map(str, arguments)], cwd=cwd, check=True)


def damped_step(time, start, angle, rate=25.0, decay=6.0):
    """Degrees; a second-order system that is let go at `start`."""
    since = max(0.0, time - start)
    wave = math.cos(rate * since) + decay / rate * math.sin(rate * since)
    return angle * (1.0 - math.exp(-decay * since) * wave)


def one_of(numbers):
    """As FFmpeg has it, which goes a hundred deep at most: by halves."""
    half = len(numbers) // 2
    return f"({one_of(numbers[:half])}+{one_of(numbers[half:])})" if half else f"eq(n,{numbers[0]})"


class FilmTest(ProgramTest):
    def pictures(self, scene, motion, numbers):
        """Of a scene and the text of a motion, those with these numbers and what else was drawn of them."""
        asked = json.dumps(scene, sort_keys=True), motion
        drawn = DRAWN[asked] = DRAWN.pop(asked, {})
        for oldest in list(DRAWN)[:-KEPT]:
            del DRAWN[oldest]
        if missing := [number for number in numbers if number not in drawn]:
            self.write("motion.csv", motion)
            self.write("scene.json", json.dumps({**scene, "pictures": missing}))
            raw = subprocess.run([RENDER, "scene.json", "motion.csv"], cwd=self.folder, check=True, stdout=subprocess.PIPE).stdout
            size = scene["width"] * scene["height"]
            drawn.update((number, raw[place * size:(place + 1) * size]) for place, number in enumerate(missing))
        return drawn

    def render(self, film, scene, motion):
        """Through FFmpeg's H.264. `motion`: rows of time and one angle (bending) or two (joints), in degrees; or the name of a
        CSV. The scene's `doubled` are the numbers of pictures in whose place the one before is shown, its `lost` of those
        that are not shown, which leave a gap."""
        if isinstance(motion, str):
            motion = (self.folder / motion).read_text()
        else:
            names = "time_s,theta1_deg,theta2_deg" if len(motion[0]) == 3 else "time_s,bending_angle_deg"
            motion = "\n".join([names, *(",".join(f"{x:.9g}" for x in row) for row in motion)]) + "\n"
        scene = {"crf": 23, "doubled": (), "lost": (), **scene}
        crf, doubled, lost, duration = (scene.pop(key) for key in ("crf", "doubled", "lost", "duration"))
        shown = []
        for number in range(int(duration * scene["rate"] + 0.5)):
            shown.append(shown[-1] if shown and number in {*doubled, *lost} else number)
        drawn = self.pictures(scene, motion, sorted(set(shown)))
        select = ["-vf", f"select='not({one_of(lost)})'", "-fps_mode", "passthrough"] if lost else []
        subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "gray", "-s", f"{scene['width']}x{scene['height']}",
                        "-r", str(scene["rate"]), "-i", "-", *select, "-c:v", "libx264", "-preset", "veryfast", "-threads", "1",
                        "-crf", str(crf), "-pix_fmt", "yuv420p", film],
                       cwd=self.folder, check=True, input=b"".join(drawn[number] for number in shown))

    def track(self, *arguments):
        result = run("track", *arguments, "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def numbers(self, name):
        return [{key: float(value) for key, value in row.items()} for row in self.table(name)]


def main():
    require_films()
    unittest.main()
