"""Two fingers that grip an object."""

import json
import unittest

from program import CONFIGS
from program import PAPER_FINGER as FINGER
from program import ProgramTest, run

BALL = ("--width-mm", "60", "--mass-g", "40", "--friction", "0.8")


class Grip(ProgramTest):
    def test_holds_a_ball_and_says_by_how_much(self):
        text = run("grip", FINGER, *BALL).stdout
        self.assertIn(": 40 g at 1.4 A.", text)
        self.assertIn("their magnets repel each other", text)
        answer = json.loads(run("grip", FINGER, *BALL, "--json").stdout)
        self.assertTrue(answer["holds"])
        self.assertAlmostEqual(answer["load_N"], 0.04 * 9.81, places=9)
        self.assertGreater(answer["capacity_N"], answer["load_N"])
        self.assertEqual([each["finger"] for each in answer["contacts"]], ["left", "right"])
        # The paper's Table III; its fingers have prices of their own.
        self.assertAlmostEqual(answer["gripper_cost_USD"], 44, delta=0.02)
        self.assertEqual(answer["pneumatic_cost_USD"], 607)
        self.assertIn("cost 44 USD; the pneumatic gripper of the paper's Table III 607 USD.\n", text)

    def test_three_fingers_hold_half_as_much_again_as_two(self):
        text = run("grip", FINGER, *BALL, "--fingers", "3").stdout
        self.assertIn("All 3 fingers touch it after ", text)
        self.assertRegex(text, r"\n  each +1 ")
        self.assertIn("\n3 such fingers with driver and supply cost 52 USD;", text)
        two = json.loads(run("grip", FINGER, *BALL, "--json").stdout)
        three = json.loads(run("grip", FINGER, *BALL, "--fingers", "3", "--json").stdout)
        self.assertEqual((two["fingers"], three["fingers"]), (2, 3))
        self.assertAlmostEqual(three["capacity_N"] / two["capacity_N"], 1.5, delta=0.05)
        self.assertEqual([each["finger"] for each in three["contacts"]], ["each"])

    def test_finds_the_least_current_and_friction(self):
        answer = json.loads(
            run("grip", FINGER, *BALL, "--least-current-up-to-A", "1.4", "--least-friction-up-to", "2", "--json").stdout)
        self.assertTrue(0.0 < answer["least_current_A"] < 1.4)
        self.assertTrue(0.0 < answer["least_friction"] < 0.8)

    def test_says_how_far_the_object_may_be_off(self):
        text = run("grip", FINGER, *BALL).stdout
        self.assertRegex(text, r"\n  height of the object  .*mm.* lower to .*mm.* higher\n"
                               r"  width of the object   .* wider\n"
                               r"  spacing of the palm   .* wider\n  mounting angle        .* further out\n")
        off = json.loads(run("grip", FINGER, *BALL, "--json").stdout)["placement_tolerance"]
        moved = [*BALL, "--centre-below-palm-mm", str(16 + off["lower_mm"]), "--json"]
        self.assertTrue(json.loads(run("grip", FINGER, *moved).stdout)["holds"])
        for sign, key in ((-1, "spacing_narrower_mm"), (1, "spacing_wider_mm")):
            palm = [*BALL, "--spacing-mm", str(70 + sign * off[key]), "--json"]
            self.assertTrue(json.loads(run("grip", FINGER, *palm).stdout)["holds"], key)
        lost = run("grip", FINGER, "--width-mm", "60", "--mass-g", "400", "--friction", "0.8", "--json")
        self.assertIsNone(json.loads(lost.stdout)["placement_tolerance"]["lower_mm"])

    def test_says_that_an_object_is_too_heavy(self):
        text = run("grip", FINGER, "--width-mm", "60", "--mass-g", "400", "--friction", "0.8").stdout
        self.assertIn("Not held: 400 g at 1.4 A.", text)

    def test_says_that_an_object_is_out_of_reach(self):
        text = run("grip", FINGER, "--width-mm", "5", "--mass-g", "4", "--friction", "0.8").stdout
        self.assertRegex(text, r"A finger does not reach the object: it stays [\d.]+ mm away\.\n")

    def test_takes_the_current_that_an_actuator_was_sized_for(self):
        sized = {**json.loads(FINGER.read_text()), "operating_point": {"current_A": 1.1}}
        self.write("sized.json", json.dumps(sized))
        self.assertIn("at 1.1 A (the actuator's operating point). ", run("grip", "sized.json", *BALL, cwd=self.folder).stdout)
        given = run("grip", "sized.json", *BALL, "--current-A", "1.2", "--json", cwd=self.folder)
        self.assertEqual(json.loads(given.stdout)["current_A"], 1.2)

    def test_says_what_a_current_does_that_no_coil_survives(self):
        text = run("grip", FINGER, *BALL, "--current-A", "100").stdout
        self.assertRegex(text, r"Heat of one finger bent like that: at 100 A nothing holds its temperature: it burns "
                               r"\(from [12]\.\d+ A on\)\.\n")
        self.assertTrue(text.startswith("Held for moments, until it burns (see below): 40 g at 100 A."), text)
        # Just beyond the runaway everything can still be computed.
        answer = json.loads(run("grip", FINGER, *BALL, "--json").stdout)
        beyond = 1.01 * answer["runaway_current_A"]
        self.assertRegex(run("grip", FINGER, *BALL, "--current-A", beyond).stdout,
                         r"can be held for good; at [\d.]+ A nothing holds its temperature: it burns \(from ")

    def test_a_hold_that_parts_do_not_survive_is_none(self):
        # The prototype's current is above what it holds for good.
        self.assertRegex(run("grip", FINGER, *BALL).stdout,
                         r"\AHeld for \d+ s from cold, not for good \(see below\): 40 g at 1\.4 A\.")
        self.assertTrue(run("grip", FINGER, *BALL, "--current-A", "1").stdout.startswith("Held: 40 g at 1 A."))
        # Magnets of a grade are lost in a field that grows with the current; flat ones near coils first.
        graded = CONFIGS / "actuators" / "finger.json"
        margins = {current: json.loads(run("grip", graded, *BALL, "--current-A", current, "--json").stdout)["demagnetisation_margin"]
                   for current in ("1", "2", "30")}
        self.assertGreater(margins["1"], 0)
        # The field over the coercivity, of which a margin tells, is linear in the current.
        load = {current: 1 - margin if margin >= 0 else 1 / (1 + margin) for current, margin in margins.items()}
        self.assertAlmostEqual(load["30"] - load["1"], 29 * (load["2"] - load["1"]), places=9)
        text = run("grip", graded, *BALL, "--current-A", "100").stdout
        self.assertRegex(text, r"\ANot for long: the magnets are lost \(see below\)\. Until then held: 40 g at 100 A\.")
        self.assertRegex(text, r"\nThe coils' field at 100 A demagnetises the magnets for good, even at 20 degC \(margin -[\d.]+, at least 0\)")

    def test_says_what_a_hold_without_end_takes_from_the_magnets(self):
        # A finger against a wall in that pose has the same heat and the same field.
        finger = CONFIGS / "actuators" / "finger.json"
        answer = json.loads(run("grip", finger, *BALL, "--current-A", "1", "--json").stdout)
        wall = json.loads(run("evaluate", finger, "--current-A", "1", "--duty", "1", "--grasp-opening-deg",
                              answer["bending_left_deg"], "--json").stdout)
        self.assertGreater(answer["irreversible_loss_held_pct"], 1)
        # That one hangs upright: the same bending, shared a little otherwise by its joints.
        self.assertAlmostEqual(answer["irreversible_loss_held_pct"] / wall["irreversible_loss_pct"], 1, delta=0.01)
        text = run("grip", finger, *BALL, "--current-A", "1").stdout
        self.assertTrue(text.startswith("Held, but the magnets weaken (see below): 40 g at 1 A. "), text)

    def test_says_that_a_hold_without_a_steady_temperature_costs_the_magnets_what_nobody_knows(self):
        finger = CONFIGS / "actuators" / "finger.json"
        self.assertIn("\nWhat a hold costs the magnets is not known: there is no steady temperature at 2 A.\n",
                      run("grip", finger, *BALL, "--current-A", "2").stdout)
        self.assertIsNone(json.loads(run("grip", finger, *BALL, "--current-A", "2", "--json").stdout)["irreversible_loss_held_pct"])

    def test_says_that_fingers_bend_past_an_object(self):
        text = run("grip", FINGER, "--width-mm", "40", "--mass-g", "100", "--friction", "1").stdout
        self.assertRegex(text, r"Both fingers touch it after [\d.]+ ms, and bend past it: in the end neither touches it\.\n")

    def test_refuses_what_makes_no_sense(self):
        for arguments, message in (
            (("--width-mm", "100", "--mass-g", "40", "--friction", "0.8"), "object must leave the open fingers free; got"),
            (("--width-mm", "100", "--mass-g", "40", "--friction", "0.8"),
             "finger; --spacing-mm, --mounting-angle-deg and --open-current-A make room\n"),
            ((*BALL, "--fingers", "8"),
             "coilwright: --mounting-angle-deg, --spacing-mm, --fingers, --polarity: mounting.spacing must leave 8 straight fingers"),
            (("--width-mm", "60", "--mass-g", "40", "--friction", "0"), "--friction"),
            (("--width-mm", "60", "--mass-g", "1e-9", "--friction", "1"), '--mass-g: must be from 0.001 to 100000; got "1e-9"'),
            (("--shape", "box", "--width-mm", "60", "--mass-g", "40", "--friction", "1"), "--height-mm: is needed for a box and an upright cylinder"),
            ((*BALL, "--height-mm", "30"), "--height-mm: belongs to a box and an upright cylinder: --width-mm is all that a sphere has"),
            ((*BALL, "--fingers", "9"), '--fingers: must be from 2 to 8; got "9"'),
            ((*BALL, "--fingers", "3", "--polarity", "opposite"), "mounting.fingers must be an even number"),
            ((*BALL, "--fingers", "3", "--shape", "cylinder"), "object must be a sphere or an upright_cylinder"),
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
