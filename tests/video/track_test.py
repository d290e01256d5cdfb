"""`coilwright tag`, `lens` and `track`: the records of rendered films, and what is said of broken ones."""

import json
import math
import os
import re
import shutil
import subprocess
import textwrap

import filming
from filming import FilmTest, damped_step, ffmpeg
from program import PAPER_FINGER, run

SMALL = {"width": 300, "height": 420, "middle": [8, 18], "rate": 120, "duration": 0.6, "exposure": 1e-3,
         "segment_tag": False, "crf": 16, "noise": 3}
STEP = [(t * 1e-3, 5 + damped_step(t * 1e-3, 0.2, 30)) for t in range(0, 1000)]
# What moves so: of one joint that rests at 5 degrees, and at 35 under 1 A.
STIFFNESS = 0.03  # Nm/rad
INERTIA = STIFFNESS / (25**2 + 6**2)  # kg m2
FINGER = {"format": "lumped-model/1", "name": "finger", "gravity_m_s2": 0,
          "links": [{"length_m": 0.03, "com_along_m": 0.01, "com_offset_m": 0, "mass_kg": 1e-3, "inertia_kgm2": INERTIA}],
          "joints": [{"stiffness_Nm_rad": STIFFNESS, "damping_Nms_rad": 2 * 6 * INERTIA,
                      "torque_offset_Nm": STIFFNESS * math.radians(5)}],
          "magnetics": [{"angle_deg": [-90, -30, 30, 90], "torque_Nmm_A": [1e3 * STIFFNESS * math.radians(30)] * 4}]}
LOG = "time_s,current_A\n0,0\n10,0\n10.5,1\n12,1\n"


def drawn(lens, ray):
    """Brown and Conrady's distortion and the pinhole, as a complex place in px."""
    k1, k2, p1, p2, k3 = lens["distortion"]
    x, y, square = ray.real, ray.imag, abs(ray) ** 2
    radial = 1 + square * (k1 + square * (k2 + square * k3))
    return complex(lens["centre_px"][0] + lens["focal_px"][0] * (x * radial + 2 * p1 * x * y + p2 * (square + 2 * x * x)),
                   lens["centre_px"][1] + lens["focal_px"][1] * (y * radial + p1 * (square + 2 * y * y) + 2 * p2 * x * y))


def left_over(true, found):
    """Px, rms over the picture, but for scale, turn and shift, which move no angle."""
    rays = [complex(x, y) / 10 for x in range(-5, 6) for y in range(-4, 5)]
    places, others = ([drawn(lens, ray) for ray in rays] for lens in (true, found))
    middle, other = (sum(each) / len(rays) for each in (places, others))
    scale = (sum((a - middle).conjugate() * (b - other) for a, b in zip(places, others))
             / sum(abs(a - middle) ** 2 for a in places))
    return math.sqrt(sum(abs(b - other - scale * (a - middle)) ** 2 for a, b in zip(places, others)) / len(rays))


class Track(FilmTest):
    def test_a_step_becomes_a_data_set_on_the_clock_of_its_log(self):
        self.render("step.mp4", SMALL, STEP)
        self.write("step.csv", LOG)
        answer = self.track("step.mp4", "--current", "step.csv", "--out", "data", "--actuator", PAPER_FINGER,
                            "--start-deg", "5", "--exposure-ms", "1", "--preview")
        data = self.result("data/dataset.json")
        self.assertEqual((data["actuator"], data["ignore"]), ("actuator.json", ["sigma_deg"]))
        entry = data["runs"][0]
        self.assertEqual({key: entry[key] for key in ("file", "kind", "drive", "start", "input_file", "exposure_s")},
                         {"file": "step.csv", "kind": "transient", "drive": "current", "start": "at_rest",
                          "input_file": "step_input.csv", "exposure_s": 0.001})
        rows = self.numbers("data/step.csv")
        self.assertEqual(list(rows[0]), ["time_s", "bending_angle_deg", "sigma_deg"])
        # The motion begins at 0.2 s of the film and, by the log, at 10.5 s; found to a quarter of a picture's interval.
        errors = [row["bending_angle_deg"] - 5 - damped_step(row["time_s"], 10.5, 30) for row in rows]
        self.assertLess(max(map(abs, errors)), 0.003 * 30 * 25)
        self.assertIn("the log's first step, at 10.5 s, is where the finger begins to move", " ".join(answer["guessed"]))
        self.assertTrue(any(name.startswith("data/step_") and name.endswith(".png") for name in self.files()))
        # diagnose takes it as it is, and finds nothing amiss in a model that moves as this film does.
        self.write("finger.json", json.dumps(FINGER))
        diagnosis = run("diagnose", "data", "--actuator", "finger.json", "--out", "answer", "--quiet", cwd=self.folder)
        self.assertEqual((diagnosis.returncode, diagnosis.stderr), (0, ""))
        self.assertEqual(self.result("answer/diagnosis.json")["verdict"], "no_missing_effect")

    def test_a_rest_that_compression_holds_is_no_still_run(self):
        # At 240 pictures a second a coarse picture is copied with its errors: it scatters, and not from one to the next.
        moves = [(time, 5 + damped_step(time, 0.4, 30)) for time, _ in STEP]
        # Where the light hardly scatters it is held for good, and does not scatter at all.
        for crf, noise, still in ((0, 3, True), (23, 3, False), (23, 0.3, False)):
            self.render("step.mp4", {**SMALL, "rate": 240, "duration": 0.7, "crf": crf, "noise": noise}, moves)
            answer = self.track("step.mp4", "--out", f"data{crf}_{noise}")
            self.assertEqual(f"data{crf}_{noise}/step_still.csv" in self.files(), still)
            self.assertEqual("compression has smoothed the pictures before it moves: they do not show the noise, and are "
                             "no still run" in " ".join(answer["guessed"]), not still)

    def test_the_same_film_gives_the_same_bytes(self):
        self.render("step.mp4", {**SMALL, "duration": 0.3}, STEP)
        self.track("step.mp4", "--out", "one")
        self.track("step.mp4", "--out", "two")
        self.assertEqual((self.folder / "one/step.csv").read_bytes(), (self.folder / "two/step.csv").read_bytes())

    def test_dropped_and_doubled_pictures_leave_gaps_and_keep_their_time(self):
        # Without loss a double is the same to the bit, at rest too; by compression it is not, and shows in a motion.
        for crf, doubled in {0: [10, 40], 16: [37, 47], 23: [37, 47]}.items():
            self.render("step.mp4", {**SMALL, "crf": crf, "lost": range(30, 34), "doubled": doubled},
                        STEP)
            answer = self.track("step.mp4", "--out", "data", "--force")
            self.assertGreaterEqual(answer["films"][0]["doubled"], len(doubled))
            times = {round(row["time_s"] * 120) for row in self.numbers("data/step.csv")}
            gone = {30, 31, 32, 33, *doubled}
            self.assertTrue(times.isdisjoint(gone), times)
            self.assertLessEqual(set(range(26, 68)) - gone, times)  # in the motion no others are gone

    def test_a_lost_picture_whose_place_another_takes_is_no_begin(self):
        # The finger is let go at 36.6 pictures; FFmpeg shows picture 37 in place of the next, which moves 13 times as much.
        moves = [(time, 5 + damped_step(time, 0.61, 30)) for time, _ in STEP]
        self.render("whole.mp4", {**SMALL, "rate": 60, "duration": 0.9, "crf": 23}, moves)
        self.write("step.csv", LOG)
        ffmpeg("-i", "whole.mp4", "-vf", "select='not(eq(n,38))',fps=60", "step.mp4", cwd=self.folder)
        for film, doubled in {"whole.mp4": 0, "step.mp4": 1}.items():
            answer = self.track(film, "--current", "step.csv", "--out", "data", "--force")
            self.assertEqual(answer["films"][0]["doubled"], doubled)
            times = [row["time_s"] for row in self.numbers(f"data/{film[:-4]}.csv")]
            phase = (times[0] - 10.5 + 0.61) * 60  # pictures, were the begin known exactly
            self.assertLess(abs(phase - round(phase)), 0.5)
            self.assertEqual(38 in [round(each * 60 - phase + round(phase) - (10.5 - 0.61) * 60) for each in times],
                             not doubled)
            self.assertLess(self.result("data/dataset.json")["runs"][0]["clock_offset_s"], 1.2 / 60)

    def test_a_begin_that_no_picture_shows_is_refused(self):
        moves = [(time, 5 + damped_step(time, 0.51, 30)) for time, _ in STEP]
        self.render("step.mp4", {**SMALL, "rate": 30, "duration": 1.0, "lost": range(13, 22)}, moves)
        self.write("step.csv", LOG)
        before = self.files()
        result = run("track", "step.mp4", "--current", "step.csv", "--out", "data", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout, self.files()), (2, "", before))
        self.assertRegex(result.stderr, r"\Acoilwright: step.mp4: must show to two pictures, 0.067 s, when the finger begins "
                         r"to move; pictures there that are noisy, doubled, missing or not read leave it open: film it again "
                         r"with more light and a shorter exposure, or with an LED that is lit with the step \(--led X,Y\); "
                         r"got 0\.\d+ s\n\Z")

    def test_a_film_of_a_variable_frame_rate_keeps_the_time_of_each_picture(self):
        # As a phone stamps them: 8.3 to 10.4 ms apart.
        lost = [number for number in range(288) if number % 17 not in {0, 4, 9, 13}]
        self.render("step.mp4", {**SMALL, "rate": 480, "lost": lost}, STEP)
        self.track("step.mp4", "--out", "data", "--opens", "counterclockwise", "--exposure-ms", "1")
        rows = self.numbers("data/step.csv")
        self.assertEqual({round(row["time_s"] * 480) % 17 for row in rows}, {0, 4, 9, 13})
        errors = [row["bending_angle_deg"] - 5 - damped_step(row["time_s"], 0.2, 30) for row in rows]
        self.assertLess(max(map(abs, errors)), 0.6)  # a millisecond is 0.5 degrees, the largest of 60 of 0.15 another 0.4

    def test_rows_of_a_film_that_a_player_turns_are_those_of_the_sensor(self):
        # As a phone held upright stores it: lying, with the turn in the container. 90 and 270 degrees clockwise.
        for turns, lay, metadata in ((1, "transpose=2", 90), (3, "transpose=1", 270)):
            self.render("seen.mp4", {**SMALL, "rate": 240, "duration": 0.5, "crf": 4, "readout": 0.012,
                                     "quarter_turns": turns}, STEP)
            ffmpeg("-i", "seen.mp4", "-vf", lay, "-crf", "12", "lying.mp4", cwd=self.folder)
            ffmpeg("-i", "lying.mp4", "-c", "copy", "-metadata:s:v", f"rotate={metadata}", "step.mp4", cwd=self.folder)
            answer = self.track("step.mp4", "--out", f"data{turns}", "--opens", "counterclockwise", "--exposure-ms", "1")
            self.assertAlmostEqual(answer["films"][0]["readout_s"], 0.012, delta=0.0015)
            self.assertIn(f"which the file turns by {metadata} deg", " ".join(answer["guessed"]))
            rows = self.numbers(f"data{turns}/step.csv")
            errors = [row["bending_angle_deg"] - 5 - damped_step(row["time_s"], 0.2, 30) for row in rows]
            self.assertLess(max(map(abs, errors)), 0.6)

    def test_a_motion_to_one_side_at_one_speed_leaves_the_rows_to_be_said(self):
        motion = [(t * 1e-3, 5 + 0.06 * t) for t in range(0, 1000)]
        self.render("turn.mp4", {**SMALL, "duration": 0.5, "crf": 20}, motion)
        answer = self.track("turn.mp4", "--out", "data", "--opens", "counterclockwise")
        self.assertEqual(answer["films"][0]["readout_s"], 0)
        self.assertIn("turn: the time in which its rows are read out, which a motion to one side at one speed does not tell from "
                      "an oblique view: --readout-ms (taken as 0)", answer["to_be_said"])
        said = self.track("turn.mp4", "--out", "data", "--force", "--readout-ms", "0")
        self.assertNotIn("rows", " ".join(said["guessed"] + said["to_be_said"]))

    def test_two_tags_on_the_finger_give_the_joints(self):
        motion = [(t, 3 + 0.6 * a, 2 + 0.4 * a) for t, a in STEP]
        self.render("step.mp4", {**SMALL, "segment_tag": True}, motion)
        self.track("step.mp4", "--out", "data", "--opens", "counterclockwise")
        truth = dict((round(t, 3), (a, b)) for t, a, b in motion)
        for row in self.numbers("data/step.csv"):
            first, second = truth[round(row["time_s"], 3)]  # between milliseconds it moves by 0.5 degrees
            self.assertAlmostEqual(row["theta1_deg"], first, delta=0.6)
            self.assertAlmostEqual(row["theta2_deg"], second, delta=0.6)

    def test_an_led_sets_the_clock(self):
        self.render("step.mp4", {**SMALL, "led": [20, 20, 0.1532]}, STEP)
        self.write("step.csv", LOG)
        self.track("step.mp4", "--current", "step.csv", "--out", "data", "--led", "20,20", "--exposure-ms", "1")
        last = self.numbers("data/step.csv")[-1]["time_s"]
        # The last picture read is a whole number of intervals after 0; the LED came at 0.1532 s, which is 10.5 s.
        phase = ((last - 10.5 + 0.1532) * 120 + 0.5) % 1 - 0.5
        self.assertLess(abs(phase), 0.5)  # between two exposures it is known to half an interval
        self.assertLess(self.result("data/dataset.json")["runs"][0]["clock_offset_s"], 0.003)

    def test_a_slow_motion_file_has_the_time_that_it_was_filmed_in(self):
        self.render("step.mp4", {**SMALL, "duration": 0.4}, STEP)
        ffmpeg("-i", "step.mp4", "-vf", "setpts=4*PTS", "-fps_mode", "passthrough", "-crf", "16", "slow.mp4",
               cwd=self.folder)
        self.track("slow.mp4", "--out", "data", "--rate-Hz", "120")
        rows = self.numbers("data/slow.csv")
        self.assertLess(abs(rows[-1]["time_s"] * 120 % 1 + 0.5) % 1 - 0.5, 0.02)
        self.assertLess(rows[-1]["time_s"], 0.4)

    def test_a_lens_is_calibrated_by_its_board(self):
        wide = {"width": 640, "height": 480, "focal": 600, "distortion": [-0.25, 0.08]}
        self.render("board.mp4", {**wide, "board": True, "px_per_mm": 1.5, "middle": [0, 0], "rate": 30, "duration": 1.0,
                                  "crf": 18, "noise": 1}, [(0.0, 0.0), (1.0, 0.0)])
        result = run("lens", "board.mp4", "--out", "lens.json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        lens = self.result("lens.json")
        self.assertLess(lens["rms_px"], 0.15)
        true = {"focal_px": [600, 600], "centre_px": [319.5, 239.5], "distortion": [*wide["distortion"], 0, 0, 0]}
        none = {**true, "distortion": [0] * 5}
        # 30 views of 54 corners, each to 0.1 px, and what lies beyond them: measured 0.02.
        self.assertLess(left_over(true, lens), 0.1)
        self.assertGreater(left_over(true, none), 3)
        # At the picture's edge: the lens turned the tags by 1.2 degrees.
        self.render("edge.mp4", {**SMALL, **wide, "middle": [30, 5], "crf": 18}, STEP)
        bias = []
        for arguments in ([], ["--lens", "lens.json"]):
            self.track("edge.mp4", "--out", "edge", "--force", "--opens", "counterclockwise", "--exposure-ms", "1",
                       *arguments)
            errors = [row["bending_angle_deg"] - 5 - damped_step(row["time_s"], 0.2, 30)
                      for row in self.numbers("edge/edge.csv")]
            bias.append(abs(sum(errors) / len(errors)))
        self.assertGreater(bias[0], 0.5)
        self.assertLess(bias[1], 0.05)
        self.render("step.mp4", {**SMALL, "duration": 0.2}, STEP)
        self.assert_refused(["track", "step.mp4", "--out", "data", "--lens", "lens.json"],
                            "lens.json: must be of pictures of 300 by 420 px, as step.mp4 has; got 640 by 480")


class InPython(FilmTest):
    """`coilwright.track`, of the same films."""

    def python(self, code, package=None):
        if "PACKAGE" not in os.environ:
            self.skipTest("this build has no Python package")
        code = f"import coilwright as cw\nFINGER = {json.dumps(FINGER)}\n{textwrap.dedent(code)}"
        return subprocess.run([os.environ["PACKAGE_PYTHON"], "-c", code], cwd=self.folder, capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(package or os.environ["PACKAGE"])}, check=False)

    def test_it_gives_the_records_of_the_program(self):
        self.render("step.mp4", {**SMALL, "duration": 0.9}, STEP)
        self.write("step.csv", LOG)
        answer = self.track("step.mp4", "--current", "step.csv", "--out", "data", "--start-deg", "5", "--preview")
        done = self.python("""
            import json, numpy as np, pathlib
            of_file = cw.track("step.mp4", "step.csv", start_deg=5, preview=True, name="data")
            rows = np.loadtxt("step.csv", delimiter=",", skiprows=1)
            of_arrays = cw.track([pathlib.Path("step.mp4")], [{"time_s": rows[:, 0], "current_A": rows[:, 1]}],
                                 start_deg=np.array([5.0]), name="data")
            assert of_arrays.records == of_file.records and of_arrays.previews == {}
            of_file.records.save("again")
            for i, png in enumerate(of_file.previews["step"]):
                assert png == pathlib.Path(f"data/step_{i + 1:02}.png").read_bytes()
            diagnosis = cw.diagnose(of_file.records, cw.Actuator.from_dict(FINGER))
            print(json.dumps([of_file.content, of_file.text, diagnosis.verdict]))
            """)
        self.assertEqual(done.stderr, "")
        content, text, verdict = json.loads(done.stdout)
        self.assertIn("data/step_input.csv", self.files())
        for name in (name[5:] for name in self.files() if re.fullmatch(r"data/.*\.csv", name)):
            self.assertEqual(*((self.folder / folder / name).read_bytes() for folder in ("data", "again")))
        self.assertEqual(self.result("again/dataset.json"), self.result("data/dataset.json"))
        self.assertEqual(content["films"], answer["films"])
        # The same sentences, that call what can be said as it is called there.
        here, there = ([each for key in ("guessed", "to_be_said") for each in said[key]] for said in (content, answer))
        there = [each for each in there if "--actuator" not in each]
        self.assertEqual(here, [re.sub(r"--[a-zA-Z-]+", lambda option: option[0][2:].replace("-", "_"), each) for each in there])
        self.assertTrue(all(each in text for each in here) and "--" not in text)
        self.assertEqual(verdict, "no_missing_effect")

    def test_what_cannot_be_used_is_refused_in_one_line(self):
        self.render("film.mp4", {**SMALL, "duration": 0.3}, STEP)
        self.write("log.csv", LOG)
        for call, told in {
                "'none.mp4'": "InputError none.mp4: cannot be opened: No such file or directory",
                "['film.mp4', 'film.mp4']": "InputError records: a run ",
                "'film.mp4', ['log.csv', 'log.csv']": "ValueError current: needs one log for each film, 1; got 2",
                "'film.mp4', opens='left'": "ValueError opens: must be 'clockwise' or 'counterclockwise'; got 'left'",
                "'film.mp4', exposure_ms=-1": "InputError exposure_ms: must be from 0 to 1000; got -1",
                "'film.mp4', start_deg=[1, 2]": "InputError start_deg: must have one angle for each tag but the base's, 1; got 2",
                "'film.mp4', {'time_s': [0, 1], 'current_A': [1, 1]}": "InputError film.mp4: needs a log whose input changes",
                "'film.mp4', 'log.csv', led=(20, 20)": "InputError film.mp4: must show the LED being lit at the place that led "
                                                       "names; its light does not change"}.items():
            done = self.python(f"""
                try:
                    cw.track({call})
                except (ValueError, RuntimeError) as error:
                    print(type(error).__name__, error)
                """)
            self.assertEqual((done.stderr, done.stdout.count("\n")), ("", 1))
            self.assertTrue(done.stdout.startswith(told), done.stdout)

    def test_without_opencv_all_else_works_and_it_says_what_to_install(self):
        self.render("film.mp4", {**SMALL, "duration": 0.3}, STEP)
        if "PACKAGE" in os.environ:
            shutil.copytree(os.environ["PACKAGE"], self.folder / "bare", ignore=shutil.ignore_patterns("*opencv*", "mypy"))
        done = self.python("""
            print(round(cw.evaluate(cw.Actuator.prototype(), current=0.3).mass_g))
            try:
                cw.track("film.mp4")
            except RuntimeError as error:
                print(error)
            """, self.folder / "bare")
        self.assertEqual(done.stderr, "")
        self.assertRegex(done.stdout, r"\A\d+\nfilms are read with OpenCV, which is not here: install .*\n\Z")


class Tags(FilmTest):
    # By the rectangles of the PDF alone, in modules from the first tag's frame; the patterns are the renderer's.
    PATTERNS = [["######", "# #  #", "## # #", "###  #", "### ##", "######"],
                ["######", "######", "#    #", "# ## #", "# # ##", "######"]]

    def test_the_sheet_has_the_tags_in_their_size_and_a_ruler_of_100_mm(self):
        result = run("tag", "--size-mm", "12", "--out", "tags.pdf", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        text = (self.folder / "tags.pdf").read_text(encoding="latin-1").split("endstream")[0]  # the first page
        mm = 72 / 25.4
        number = r"(-?[\d.]+)"
        boxes = [[float(x) / mm for x in each] for each in re.findall(" ".join([number] * 4) + " re f", text)]
        self.assertEqual(sum(abs(box[2] - 100) < 1e-3 for box in boxes), 1)
        frames = [[float(x) / mm for x in each] for each in re.findall(" ".join([number] * 4) + " re S", text)]
        self.assertTrue(all(abs(frame[2] - 16) < 1e-3 for frame in frames))
        rows = sorted({round(frame[1], 3) for frame in frames}, reverse=True)
        for pattern, bottom in zip(self.PATTERNS, rows):
            left = min(frame[0] for frame in frames if abs(frame[1] - bottom) < 1e-2)
            for i in range(6):
                for j in range(6):
                    x, y = left + 2 * (j + 1.5), bottom + 16 - 2 * (i + 1.5)
                    black = any(b[0] <= x <= b[0] + b[2] and b[1] <= y <= b[1] + b[3] for b in boxes)
                    self.assertEqual(black, pattern[i][j] == "#", (bottom, i, j))

    def test_a_size_that_is_none_is_refused(self):
        self.assert_refused(["tag", "--size-mm", "1", "--out", "tags.pdf"],
                            'tag: --size-mm: must be from 2 to 40; got "1" (see coilwright tag --help)')


class Broken(FilmTest):
    def refused(self, rule, film="film.mp4", *arguments):
        self.assert_refused(["track", film, "--out", "data", *arguments], f"{film}: {rule}")

    def step(self, **changes):
        self.render("film.mp4", {**SMALL, "duration": 0.3, **changes}, STEP)

    def test_a_film_without_a_tag(self):
        ffmpeg("-f", "lavfi", "-i", "testsrc=s=320x240:r=30:d=0.3", "film.mp4", cwd=self.folder)
        self.refused("must show a tag of `coilwright tag`; none was found: light it, hold it in focus, at least 15 px wide")

    def test_a_mirrored_film(self):
        self.step()
        ffmpeg("-i", "film.mp4", "-vf", "hflip", "mirrored.mp4", cwd=self.folder)
        self.refused("must not be mirrored, as by a phone's front camera; its tags can be read in a mirror only",
                     "mirrored.mp4")

    def test_two_tags_alike(self):
        self.step()
        ffmpeg("-i", "film.mp4", "-vf", "split[a][b];[a][b]hstack", "two.mp4", cwd=self.folder)
        self.refused("must show each tag once; tag 0 is there twice in one picture", "two.mp4")

    def test_a_file_that_was_cut_a_large_one_of_nothing_and_one_of_sound(self):
        rule = "must be a film that FFmpeg can read; it has no pictures, or is damaged"
        self.step()
        self.write("cut.mp4", (self.folder / "film.mp4").read_bytes()[:9000])
        self.refused(rule, "cut.mp4")
        with open(self.folder / "large.mp4", "wb") as file:
            file.truncate(4 << 30)
        result = run("track", "large.mp4", "--out", "data", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (2, f"coilwright: large.mp4: {rule}\n"))
        (self.folder / "large.mp4").unlink()
        ffmpeg("-f", "lavfi", "-i", "sine=d=0.3", "sound.m4a", cwd=self.folder)
        self.refused(rule, "sound.m4a")

    def test_files_that_are_not_there(self):
        self.write("empty.mp4", "")
        (self.folder / "folder.mp4").mkdir()
        for film, rule in {"missing.mp4": "cannot be opened: No such file or directory",
                           "folder.mp4": "must be a file, and is a folder", "empty.mp4": "must not be empty"}.items():
            self.refused(rule, film)
            self.assert_refused(["lens", film, "--out", "lens.json"], f"{film}: {rule}")

    def test_a_picture_and_a_film_of_one_picture(self):
        self.step()
        ffmpeg("-i", "film.mp4", "-frames:v", "1", "one.png", cwd=self.folder)
        self.refused("must be a film; it has one picture", "one.png")
        ffmpeg("-loop", "1", "-i", "one.png", "-t", "0.4", "-r", "30", "-c:v", "ffv1", "still.mkv", cwd=self.folder)
        self.assertRegex(run("track", "still.mkv", "--out", "data", cwd=self.folder).stderr,
                         r"^coilwright: still.mkv: must be a film; its \d+ pictures are one and the same\n$")

    def test_a_tip_that_leaves_the_picture_is_a_gap(self):
        self.step(duration=0.6, middle=[-8, 18])
        answer = self.track("film.mp4", "--out", "data")
        self.assertLess(answer["films"][0]["read"], answer["films"][0]["pictures"] - 5)
        self.assertGreater(answer["films"][0]["read"], 20)

    def test_logs_that_do_not_fit(self):
        self.step()
        self.write("flat.csv", "time_s,current_A\n0,1\n5,1\n")
        self.refused("needs a log whose input changes: by its first step the two clocks are brought together; this one's "
                     "never changes", "film.mp4", "--current", "flat.csv")
        self.write("log.csv", LOG)
        self.assert_refused(["track", "film.mp4", "--out", "data", "--current", "log.csv", "log.csv"],
                            "track: --current: needs one log for each film, 1; got 2 (see coilwright track --help)")
        self.refused("must show the LED being lit at the place that --led names; its light does not change", "film.mp4",
                     "--current", "log.csv", "--led", "20,20")


if __name__ == "__main__":
    filming.main()
