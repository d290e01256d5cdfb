"""A supply whose voltage does not drive the current: every command that knows of both says so."""

import csv
import json
import unittest

from program import PAPER_FINGER, ProgramTest, run
from study import write_study

LUMPED = {"format": "lumped-model/1", "name": "pendulum",
          "links": [{"length_m": 0.04, "com_along_m": 0.02, "com_offset_m": 0, "mass_kg": 0.03, "inertia_kgm2": 4e-6}],
          "joints": [{"stiffness_Nm_rad": 0.012, "damping_Nms_rad": 8e-5}], "magnetics": [None]}
SUPPLY = "MIND: the supply of the actuator's operating_point drives "
STUDY = {"operating_point": {"duty": 0.5, "grasp_opening_deg": 0}, "constraints": None,
         "variables": {"current_A": {"lower": 0.1, "upper": 1.4}, "turns_radial": {"lower": 10, "upper": 17}}}


class Supply(ProgramTest):
    def finger(self, **point):
        self.write("finger.json", json.dumps({**json.loads(PAPER_FINGER.read_text()),
                                              "operating_point": {"current_A": 1, **point}}))

    def load_of(self, *words):
        answer = json.loads(run("evaluate", PAPER_FINGER, *words, "--json").stdout)
        rows = [each for each in answer["part_limits"] if each["quantity"] == "supply_load"]
        return answer, rows

    def study(self, voltage, **changes):
        point = {**STUDY["operating_point"], **changes.pop("operating_point", {})}
        if voltage is not None:
            point["supply_voltage_V"] = voltage
        write_study(self, **{**STUDY, "operating_point": point, **changes})

    def size(self):
        result = run("size", "study.json", "--out", "out", "--force", "--answer-only", "--quiet", cwd=self.folder)
        return result, self.result("out/result.json")

    def test_evaluate_has_it_as_a_limit_that_is_broken(self):
        self.assertEqual(self.load_of("--current-A", "1")[1], [])
        for words in ((), ("--wiring", "series"), ("--supply-resistance-Ohm", "0.4"), ("--duty", "0.2"),
                      ("--set", "ambient_degC=60"), ("--current-A", "-1")):
            current = words if words[:1] == ("--current-A",) else ("--current-A", "1", *words)
            needed = self.load_of(*current)[0]["supply_voltage_V"]
            for voltage, broken in ((needed, False), (0.999999 * needed, True), (0.4 * needed, True), (2 * needed, False)):
                with self.subTest(words, voltage=voltage / needed):
                    [row] = self.load_of(*current, "--supply-voltage-V", repr(voltage))[1]
                    self.assertEqual((row["broken"], row["at_most"], row["conditional"]), (broken, 1, False))
                    self.assertAlmostEqual(row["value"], needed / voltage, places=9)
                    text = run("evaluate", PAPER_FINGER, *current, "--supply-voltage-V", repr(voltage)).stdout
                    self.assertEqual("BROKEN: the supply has not the voltage to drive this current through the warm coils" in text,
                                     broken)

    def test_a_runaway_needs_more_than_any_supply_has(self):
        [row] = self.load_of("--current-A", "5", "--supply-voltage-V", "1000")[1]
        self.assertEqual((row["value"], row["broken"]), (None, True))

    def test_a_voltage_that_is_none_is_refused(self):
        for voltage in ("0", "-1", "nan"):
            self.assertEqual(run("evaluate", PAPER_FINGER, "--current-A", "1", "--supply-voltage-V", voltage).returncode, 2)
            if voltage != "nan":
                self.study(float(voltage))
                self.assert_refused(["size", "study.json", "--out", "out"],
                                    f"study.json: /operating_point/supply_voltage_V: must be > 0; got {voltage}")

    def test_a_lumped_model_has_no_resistance_for_it(self):
        self.write("model.json", json.dumps(LUMPED))
        self.assert_refused(("evaluate", "model.json", "--current-A", "1", "--supply-voltage-V", "5"),
                            "model.json: is a lumped model, whose coils have no resistance: leave the voltage of the supply out")

    def test_size_finds_what_the_supply_can_drive(self):
        self.study(None)
        _, free = self.size()
        self.assertNotIn("supply_load", free["performance"])
        for share in (0.5, 0.25):
            voltage = share * free["performance"]["supply_voltage_V"]
            self.study(voltage)
            result, found = self.size()
            self.assertEqual(result.returncode, 0)
            self.assertLessEqual(found["performance"]["supply_voltage_V"], voltage)
            self.assertLess(found["performance"]["peak_bending_speed_deg_s"], free["performance"]["peak_bending_speed_deg_s"])
            self.assertRegex(result.stdout, "supply_load +")
            # The limit is where the best design stands.
            self.assertGreater(found["performance"]["supply_voltage_V"], 0.95 * voltage)
            self.assertAlmostEqual(found["performance"]["supply_load"], found["performance"]["supply_voltage_V"] / voltage)
        self.study(0.01)
        result, found = self.size()
        self.assertEqual((result.returncode, found["feasible"]), (3, False))
        self.assertNotIn("BEWARE", result.stdout.split("What")[0])

    def test_a_limit_of_ones_own_counts_where_it_asks_for_more(self):
        for at_most, told in ((0.8, "<= 0.8"), (2, "<= 1")):
            self.study(3.0, constraints=[{"quantity": "supply_load", "at_most": at_most}])
            self.assertIn(told, self.size()[0].stdout)
        self.study(None, constraints=[{"quantity": "supply_load", "at_most": 1}])
        self.assertEqual(run("size", "study.json", "--out", "out", "--force", cwd=self.folder).returncode, 2)

    def test_sweep_and_pareto_take_no_other(self):
        variables = {"current_A": {"values": [0.2, 0.6, 1.0]}, "turns_radial": {"values": [10, 14]}}
        self.study(1.6, variables=variables)
        self.assertEqual(run("sweep", "study.json", "--out", "swept", "--quiet", cwd=self.folder).returncode, 0)
        with open(self.folder / "swept/designs.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        kept = [float(row["supply_voltage_V"]) <= 1.6 for row in rows]
        self.assertEqual([row["status"] == "ok" for row in rows], kept)
        self.assertEqual({True, False}, set(kept))
        self.study(1.6, objectives=[{"maximise": "peak_bending_speed_deg_s"}, {"minimise": "mass_g"}])
        self.assertEqual(run("pareto", "study.json", "--out", "front", "--quiet", cwd=self.folder).returncode, 0)
        with open(self.folder / "front/front.csv", encoding="utf-8") as file:
            self.assertTrue(all(float(row["supply_voltage_V"]) <= 1.6 for row in csv.DictReader(file)))

    def yield_of(self, voltage, spread, **changes):
        self.study(voltage, spread=spread, **{"operating_point": {"current_A": 1}, "variables": {"gap_mm": {"lower": 0.7, "upper": 1.6}}, **changes})
        result = run("yield", "study.json", "finger.json", "--builds", "200", "--json", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def test_builds_that_it_cannot_drive_keep_nothing(self):
        needed = json.loads(run("evaluate", PAPER_FINGER, "--current-A", "1", "--duty", "0.5", "--json").stdout)["supply_voltage_V"]
        spread = {"current_A": {"relative_sd": 0.02}}
        shares = [self.yield_of(factor * needed, spread)["keeps_all"]["share"] for factor in (0.8, 1.0, 1.2)]
        self.assertEqual((shares[0], shares[2]), (0, 1))
        self.assertTrue(0.2 < shares[1] < 0.8, shares)
        # The supply itself scatters as well: half of them have less than meant. A charge that falls all of them meet.
        for of, low, high in (("part", 0.2, 0.8), ("use", -0.1, 0.1)):
            own = self.yield_of(needed, {"supply_voltage_V": {"relative_sd": 0.02, "of": of}})
            self.assertTrue(low < own["keeps_all"]["share"] < high, of)
        self.study(None, operating_point={"current_A": 1}, spread={"supply_voltage_V": {"sd": 0.1}}, variables={"gap_mm": {"lower": 0.7, "upper": 1.6}})
        self.assert_refused(["size", "study.json", "--out", "out"],
                            "study.json: /spread/supply_voltage_V: scatters nothing: give operating_point.supply_voltage_V, the voltage meant")

    def test_a_statistic_counts_them_as_beyond_every_limit(self):
        needed = json.loads(run("evaluate", PAPER_FINGER, "--current-A", "1", "--duty", "0.5", "--json").stdout)["supply_voltage_V"]
        for factor, status in ((1.01, "failed"), (1.3, "ok")):
            self.study(factor * needed, operating_point={"current_A": 1}, spread={"current_A": {"relative_sd": 0.05}},
                       variables={"gap_mm": {"values": [json.loads(PAPER_FINGER.read_text())["body"]["gap_mm"]]}},
                       objectives=[{"maximise": "p05_peak_bending_speed_deg_s"}])
            run("sweep", "study.json", "--out", "swept", "--force", "--quiet", cwd=self.folder)
            with open(self.folder / "swept/designs.csv", encoding="utf-8") as file:
                self.assertEqual([row["status"] for row in csv.DictReader(file)], [status])

    def test_commands_of_motion_say_it_with_cold_coils(self):
        cold = json.loads(run("evaluate", PAPER_FINGER, "--current-A", "1", "--json").stdout)["supply_voltage_cold_V"]
        for words in (("simulate", "finger.json", "--step-A", "1", "--duration-s", "0.1", "--out", "out.csv"),
                      ("linearise", "finger.json", "--current-A", "1"), ("reach", "finger.json", "--angle-deg", "40")):
            for voltage, told in ((None, False), (0.3 * cold, True), (3 * cold, False)):
                self.finger(**({} if voltage is None else {"supply_voltage_V": voltage}))
                result = run(*words, cwd=self.folder)
                self.assertEqual(result.returncode, 0)
                with self.subTest(words[0], voltage=voltage):
                    self.assertEqual(SUPPLY in result.stderr, told)

    def test_grip_says_it_with_coils_as_warm_as_in_a_hold(self):
        ball = ("--width-mm", "60", "--mass-g", "40", "--friction", "0.8")
        for voltage, told in ((2.0, True), (20.0, False)):
            self.finger(supply_voltage_V=voltage, current_A=1.2)
            self.assertEqual(SUPPLY in run("grip", "finger.json", *ball, cwd=self.folder).stdout, told)
            driven = json.loads(run("grip", "finger.json", *ball, "--json", cwd=self.folder).stdout)["supply_driven_current_A"]
            self.assertEqual(driven < 1.2, told)


if __name__ == "__main__":
    unittest.main()
