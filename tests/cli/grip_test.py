"""Two fingers that grip an object."""

import json
import unittest

from program import PAPER_FINGER as FINGER
from program import ProgramTest, run

BALL = ("--width-mm", "60", "--mass-g", "40", "--friction", "0.8")


class Grip(ProgramTest):
    def test_holds_a_ball_and_says_by_how_much(self):
        text = run("grip", FINGER, *BALL).stdout
        self.assertIn("Held: 40 g at 1.4 A.", text)
        self.assertIn("their magnets repel each other", text)
        answer = json.loads(run("grip", FINGER, *BALL, "--json").stdout)
        self.assertTrue(answer["holds"])
        self.assertAlmostEqual(answer["load_N"], 0.04 * 9.81, places=9)
        self.assertGreater(answer["capacity_N"], answer["load_N"])
        self.assertEqual([each["finger"] for each in answer["contacts"]], ["left", "right"])

    def test_finds_the_least_current_and_friction(self):
        answer = json.loads(
            run("grip", FINGER, *BALL, "--least-current-up-to-A", "1.4", "--least-friction-up-to", "2", "--json").stdout)
        self.assertTrue(0.0 < answer["least_current_A"] < 1.4)
        self.assertTrue(0.0 < answer["least_friction"] < 0.8)

    def test_says_that_an_object_is_too_heavy(self):
        text = run("grip", FINGER, "--width-mm", "60", "--mass-g", "400", "--friction", "0.8").stdout
        self.assertIn("Not held: 400 g at 1.4 A.", text)

    def test_says_that_an_object_is_out_of_reach(self):
        text = run("grip", FINGER, "--width-mm", "5", "--mass-g", "4", "--friction", "0.8").stdout
        self.assertIn("A finger does not reach the object.", text)

    def test_refuses_what_makes_no_sense(self):
        for arguments, message in (
            (("--width-mm", "100", "--mass-g", "40", "--friction", "0.8"), "object must leave the open fingers free; got"),
            (("--width-mm", "60", "--mass-g", "40", "--friction", "0"), "--friction"),
            (("--shape", "box", "--width-mm", "60", "--mass-g", "40", "--friction", "1"), "--height-mm: is needed for a box"),
            ((*BALL, "--mounting-angle-deg", "90"), "--mounting-angle-deg"),
            ((*BALL, "--polarity", "up"), '--polarity: must be one of "same", "opposite"; got "up"'),
        ):
            result = run("grip", FINGER, *arguments)
            self.assertEqual(result.returncode, 2)
            self.assertIn(message, result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
            self.assertEqual(result.stdout, "")


if __name__ == "__main__":
    unittest.main()
