"""`coilwright reach`: a current profile to an angle, the header for a microcontroller, and every way to ask wrongly."""

import csv
import functools
import json
import shutil
import subprocess
import unittest

from program import CONFIGS, DATA, PAPER_FINGER, ProgramTest, run

FINGER = CONFIGS / "actuators" / "finger.json"
LUMPED = DATA / "formats" / "lumped_model.json"
# The shortest search, where any profile will do.
ANY = ("--pieces", "1")

MAIN = """
#include <stdio.h>
#include "finger.h"
int main(void) {
  CW_REAL angle[CW_JOINTS] = {START}, rate[CW_JOINTS] = {0};
  const CW_REAL step = (CW_REAL)0.0005;
  int i, j;
  for (i = 0; i <= 2000; ++i) {
    CW_REAL bending = 0;
    for (j = 0; j < CW_JOINTS; ++j) bending += angle[j];
    if (i % 20 == 0) printf("%.9g %.9g\\n", 0.0005 * i, (double)bending * 57.29577951308232);
    cw_step(angle, rate, cw_profile_current(step * (CW_REAL)i + (CW_REAL)1e-7), step);
  }
  return 0;
}
"""


@functools.cache
def fifty_degrees():
    result = run("reach", PAPER_FINGER, "--angle-deg", "50", "--json")
    return result.returncode, result.stderr, json.loads(result.stdout)


class Reach(ProgramTest):
    def reach(self, *options, actuator=PAPER_FINGER):
        result = run("reach", actuator, *options, "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def motion(self, input_file, actuator=PAPER_FINGER):
        """Another route: the command simulate, bending angle in deg by time in s from the start of the profile."""
        result = run("simulate", actuator, "--input", input_file, "--out", "motion.csv", cwd=self.folder)
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"\A(The samples of \S+ are up to .*\n)?\Z")
        with open(self.folder / "motion.csv", newline="") as file:
            return {float(row["time_s"]): float(row["bending_angle_deg"]) for row in csv.DictReader(file)}

    def dense(self, profile, duration):
        """The profile with a row each 2 ms, so that simulate shows the motion there."""
        rows = sorted({*(round(0.002 * i, 6) for i in range(int(duration / 0.002) + 1)), *profile["time_s"]})
        lines = ["time_s,current_A", "-0.01,0"]
        for time in rows:
            level = [a for t, a in zip(profile["time_s"], profile["current_A"]) if t <= time][-1]
            lines.append(f"{time!r},{level!r}")
        self.write("dense.csv", "\n".join(lines) + "\n")
        return "dense.csv"

    def test_the_searched_profile_arrives_when_it_says(self):
        returned, said, answer = fifty_degrees()
        self.assertEqual((returned, said), (0, ""))
        by_name = {each["name"]: each for each in answer["profiles"]}
        self.assertEqual(list(by_name), ["step", "zero_vibration", "zero_vibration_derivative", "searched"])
        band = 0.02 * abs(answer["end_deg"] - answer["start_deg"])
        for name, profile in by_name.items():
            motion = self.motion(self.dense(profile, 1.2))
            outside = [time for time, angle in motion.items() if abs(angle - answer["end_deg"]) > band]
            self.assertAlmostEqual(max(outside), profile["nominal"]["settling_time_s"], delta=0.003, msg=name)
            overshoot = 100 * (max(motion.values()) - answer["end_deg"]) / (answer["end_deg"] - answer["start_deg"])
            self.assertAlmostEqual(max(0, overshoot), profile["nominal"]["overshoot_percent"], delta=0.3, msg=name)

    def test_the_worst_finger_is_one_with_other_hinges(self):
        """k and b of the file turned as far: the last of the five is as late as was said."""
        lumped = json.loads(LUMPED.read_text())
        answer = self.reach("--angle-deg", "30", "--highest-current-A", "1.4", actuator=LUMPED)
        best = answer["profiles"][-1]
        input_file = self.dense(best, 1.5)
        late, ends = [], []
        for k, b in ((1, 1), (0.9, 0.9), (0.9, 1.1), (1.1, 0.9), (1.1, 1.1)):
            other = json.loads(json.dumps(lumped))
            for joint in other["joints"]:
                joint["stiffness_Nm_rad"] *= k
                joint["damping_Nms_rad"] *= b
            self.write("other.json", json.dumps(other))
            motion = self.motion(input_file, "other.json")
            start, end = motion[min(motion)], motion[max(motion)]
            ends.append(end)
            late.append(max(time for time, angle in motion.items() if abs(angle - end) > 0.02 * abs(end - start)))
        self.assertAlmostEqual(max(late), best["worst"]["settling_time_s"], delta=0.004)
        self.assertAlmostEqual(late[0], best["nominal"]["settling_time_s"], delta=0.004)
        self.assertAlmostEqual(min(ends), answer["least_end_deg"], delta=0.05)
        self.assertAlmostEqual(max(ends), answer["greatest_end_deg"], delta=0.05)
        self.assertLess(max(late), 0.4 * answer["profiles"][0]["worst"]["settling_time_s"])

    def test_the_table_and_the_file_have_the_numbers_of_the_json(self):
        result = run("reach", PAPER_FINGER, "--angle-deg", "50", "--out", "profile.csv", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        answer = fifty_degrees()[2]
        self.assertIn(f"{answer['holding_current_A']:.4g} A hold it.", result.stdout)
        best = answer["profiles"][-1]
        self.assertIn(f"Best at worst, searched: {best['current_A'][0]:.3f} A for ", result.stdout)
        with open(self.folder / "profile.csv", newline="") as file:
            rows = [(float(row["time_s"]), float(row["current_A"])) for row in csv.DictReader(file)]
        self.assertEqual(rows[0], (-0.01, 0.0))
        self.assertEqual([time for time, _ in rows[1:-1]], best["time_s"])
        self.assertEqual([current for _, current in rows[1:-1]], best["current_A"])
        end = list(self.motion("profile.csv").values())[-1]
        self.assertAlmostEqual(end, 50, delta=0.02 * (answer["end_deg"] - answer["start_deg"]))

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_the_header_moves_as_the_program(self):
        self.assert_header_moves_as_the_program(PAPER_FINGER, ("float", "double"))

    @unittest.skipUnless(shutil.which("cc"), "needs a C compiler")
    def test_the_header_has_the_shares_of_the_coils(self):
        finger = json.loads(PAPER_FINGER.read_text(encoding="utf-8"))
        finger["coil"]["current_share_2"] = 0.6
        self.write("shared.json", json.dumps(finger))
        self.assert_header_moves_as_the_program(self.folder / "shared.json", ("double",))

        header = (self.folder / "finger.h").read_text(encoding="utf-8")
        self.assertIn("of the current of which the coils, base to tip, carry 1 and 0.6,", header)
        self.assertNotIn("every coil", header)

    def test_half_the_shares_reach_as_far(self):
        shares = ("--set", "current_share_1=0.5", "--set", "current_share_2=0.5")
        half = self.reach("--angle-deg", "50", *shares, *ANY)  # 47.7 deg at half of the wire's current
        self.assertAlmostEqual(half["holding_current_A"], 2 * fifty_degrees()[2]["holding_current_A"], places=6)

    def assert_header_moves_as_the_program(self, actuator, reals):
        profile = self.reach("--angle-deg", "50", "--c-header", "finger.h", *ANY, actuator=actuator)["profiles"][-1]
        start = run("simulate", actuator, "--step-A", "0", "--duration-s", "0.01", "--out", "rest.csv", cwd=self.folder)
        self.assertEqual(start.returncode, 0)
        with open(self.folder / "rest.csv", newline="") as file:
            rest = next(csv.DictReader(file))
        angles = ", ".join(str(float(rest[f"theta{j}_deg"]) / 57.29577951308232) for j in (1, 2))
        self.write("main.c", MAIN.replace("START", angles))
        # The microcontroller changes the current at its steps; simulate gets the same.
        steps = [round(0.0005 * i, 6) for i in range(2001)]
        at_steps = [max(i for i, time in enumerate(profile["time_s"]) if time <= step + 1e-7) for step in steps]
        motion = self.motion(self.dense({"time_s": steps, "current_A": [profile["current_A"][i] for i in at_steps]}, 1.0),
                             actuator)
        for real in reals:
            build = subprocess.run(["cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
                                    f"-DCW_REAL={real}", "main.c", "-o", "main", "-lm"], cwd=self.folder,
                                   capture_output=True, text=True)
            self.assertEqual((build.returncode, build.stderr), (0, ""))
            lines = subprocess.run([str(self.folder / "main")], capture_output=True, text=True).stdout.splitlines()
            worst = max(abs(float(angle) - motion[round(float(time), 6)]) for time, angle in map(str.split, lines))
            self.assertLess(worst, 0.01, real)

    def test_an_output_that_cannot_be_written_leaves_nothing(self):
        self.assert_refused(("reach", PAPER_FINGER, "--angle-deg", "50", "--c-header", "finger.h", "--out", "none/a.csv"),
                            "none/a.csv: cannot be written: No such file or directory")
        # Told before the search, which would have refused the angle.
        for option in ("--out", "--c-header"):
            self.assert_refused(("reach", PAPER_FINGER, "--angle-deg", "100", option, "none/a"),
                                "none/a: cannot be written: No such file or directory")

    def test_another_file_is_kept_and_its_own_kind_replaced(self):
        outputs = (("--out", "a.csv"), ("--c-header", "a.h"))
        for option, name in outputs:
            self.write(name, "my notes\n")
            # The second angle is one that the search would refuse: it is told before.
            for angle in ("40", "100"):
                self.assert_refused(("reach", PAPER_FINGER, "--angle-deg", angle, *ANY, option, name),
                                    f"{name}: cannot be written: it holds something else; --force replaces it, "
                                    "another --out keeps it")
        both = [word for output in outputs for word in output]
        self.assertEqual(run("reach", PAPER_FINGER, "--angle-deg", "40", *both, *ANY, "--force", cwd=self.folder).returncode, 0)
        first = self.files()
        self.assertEqual(run("reach", PAPER_FINGER, "--angle-deg", "30", *both, *ANY, cwd=self.folder).returncode, 0)
        for _, name in outputs:
            self.assertNotEqual(self.files()[name], first[name])

    def test_refuses_what_makes_no_sense(self):
        finger = json.loads(PAPER_FINGER.read_text())
        finger["effects"] = [{"id": "coil_lag", "parameters": {"time_constant_ms": 10}}]
        self.write("lagging.json", json.dumps(finger))
        finger["effects"] = [{"id": "dry_friction", "parameters": {"torque_Nmm": 0.5}}]
        self.write("sticking.json", json.dumps(finger))
        self.write("lumped.json", LUMPED.read_bytes())
        for arguments, message in (
            ((PAPER_FINGER,), "reach: --angle-deg is required (see coilwright reach --help)"),
            ((PAPER_FINGER, "--angle-deg", "100"),
             f"{PAPER_FINGER}: angle must be from 21.07 to 63.62 deg, which 0 to 1.4 A hold; got 100 deg"),
            ((PAPER_FINGER, "--angle-deg", "40", "--highest-current-A", "-1"),
             f"{PAPER_FINGER}: highest current must be finite and above the lowest; got -1"),
            ((PAPER_FINGER, "--angle-deg", "40", "--from-A", "2"),
             f"{PAPER_FINGER}: start current must be from 0 to 1.4 A, the lowest and the highest; got 2 A"),
            ((PAPER_FINGER, "--angle-deg", "40", "--pieces", "0"), "reach: --pieces: must be from 1 to 6; got \"0\" (see coilwright reach --help)"),
            ((PAPER_FINGER, "--angle-deg", "40", "--stiffness-error-percent", "80"),
             "reach: --stiffness-error-percent: must be from 0 to 50; got \"80\" (see coilwright reach --help)"),
            ((PAPER_FINGER, "--angle-deg", "40", "--out", "a.csv", "--c-header", "./a.csv"),
             "--c-header: must be another file than that of --out"),
            (("sticking.json", "--angle-deg", "40"),
             "sticking.json: effect dry_friction: a joint that sticks stops short of an angle or beyond it, which a "
             "profile without a sensor cannot mend; take the effect out to see the rest, 0.3983 A hold the angle without "
             "it"),
            (("lumped.json", "--angle-deg", "40"),
             "--highest-current-A: is needed: a lumped model does not say what current its coils bear"),
            (("lagging.json", "--angle-deg", "40", "--c-header", "finger.h"),
             "lagging.json: a C header has no effects; take them out of the actuator, or do without the header"),
            ((FINGER, "--set", "configuration=C", "--angle-deg", "40", "--c-header", "finger.h"),
             f"{FINGER}: a C header has the pairs of neighbours alone; this actuator has coils and magnets that act "
             "on each other across more than one joint"),
        ):
            with self.subTest(message):
                self.assert_refused(("reach", *arguments), message)


if __name__ == "__main__":
    unittest.main()
