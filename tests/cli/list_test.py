"""`coilwright list`: what the program knows, with the names, units and bounds that its readers use."""

import json
import math
import re
import unittest

from program import CONFIGS, PAPER_FINGER, ProgramTest, run


def rows(what):
    result = run("list", what, "--json")
    assert (result.returncode, result.stderr) == (0, ""), result.stderr
    return json.loads(result.stdout)


class List(ProgramTest):
    def test_quantities_are_those_that_evaluate_prints_and_a_study_takes(self):
        printed = json.loads(run("evaluate", PAPER_FINGER, "--current-A", "1", "--json").stdout)
        names = [key for key, value in printed.items() if not isinstance(value, (list, dict))]
        listed = rows("quantities")
        self.assertEqual([row["key"] for row in listed if row["of"] == "evaluate"], names)
        of_blocks = json.loads((CONFIGS / "schemas/study.schema.json").read_text())["$defs"]["quantity_of_block"]["enum"]
        self.assertEqual([row["key"] for row in listed if row["of"] != "evaluate"], of_blocks)
        self.assertEqual({row["of"] for row in listed}, {"evaluate", "gripper", "crawler", "driver"})
        for row in listed:
            self.assertTrue(row["meaning"], row["key"])
            self.assertTrue(row["key"].endswith(row["unit"]), row)

    def test_parameters_have_the_place_and_the_bounds_of_a_file(self):
        self.write("finger.json", PAPER_FINGER.read_text())
        listed = {row["key"]: row for row in rows("parameters")}
        self.assertEqual(listed["gap_mm"], {
            "key": "gap_mm", "in_file": "/body/gap_mm", "unit": "mm", "range": "from 0.05 to 1000",
            "meaning": "Coil face to magnet face with the joint straight."})
        self.assertEqual(listed["magnet_radius_mm"]["in_file"], "/magnet/radius_mm")
        self.assertIn("N42SH", listed["magnet_grade"]["range"].split(", "))
        # Far outside all of them: the refusal has the range that is listed.
        for key, row in listed.items():
            if key in ("magnet_grade", "enamel", "filler", "silicone", "bottom_silicone"):  # names
                continue
            with self.subTest(key):
                result = run("evaluate", "finger.json", "--current-A", "1", "--set", f"{key}=-1e9", cwd=self.folder)
                rule = row["range"].removeprefix("whole, ")
                self.assertEqual(result.stderr, f"coilwright: {key}=-1e9: must be {rule}\n")

    def test_effects_come_with_their_numbers(self):
        listed = rows("effects")
        schema = json.loads((CONFIGS / "schemas/effects.schema.json").read_text())
        for effect in schema["items"]["oneOf"]:
            numbers = [row["key"] for row in listed if row["effect"] == effect["title"] and row["key"] is not None]
            known = [key for key in effect["properties"]["parameters"].get("properties", {}) if key != "comment"]
            self.assertEqual(sorted(numbers), sorted(known), effect["title"])
        torque = next(row for row in listed if (row["effect"], row["key"]) == ("dry_friction", "torque_Nmm"))
        self.assertEqual((torque["unit"], torque["range"]), ("Nmm", "from 0 to 1000000000000"))
        self.assertTrue(all(row["meaning"] for row in listed))

    def test_gauges_magnets_and_silicones(self):
        gauges = {row["wire_gauge_AWG"]: row for row in rows("gauges")}
        self.assertEqual(sorted(gauges), list(range(10, 51)))
        self.assertEqual(gauges[28]["chassis_current_A"], 1.4)
        # ASTM B258, and a copper wire of 1.68e-8 to 1.73e-8 Ohm m.
        self.assertAlmostEqual(gauges[28]["bare_diameter_mm"], 0.127 * 92 ** ((36 - 28) / 39), places=9)
        section = math.pi / 4 * (gauges[28]["bare_diameter_mm"] * 1e-3) ** 2
        self.assertTrue(1.68e-8 < gauges[28]["resistance_Ohm_m"] * section < 1.73e-8)
        magnets = {row["grade"]: row for row in rows("magnets")}
        self.assertTrue(1.42 <= magnets["N52"]["remanence_T"] <= 1.48)
        self.assertEqual(magnets["N52"]["price_over_N52"], 1)
        self.assertEqual(magnets["N42SH"]["temperature_limit_degC"], 150)
        silicones = rows("silicones")
        self.assertEqual([row["youngs_modulus_MPa"] for row in silicones if row["silicone"] == "Ecoflex 00-30"],
                         [silicones[2]["youngs_modulus_MPa"]])
        # 10 psi at 100 %.
        self.assertAlmostEqual(silicones[2]["youngs_modulus_MPa"], 10 * 6894.757e-6 * 12 / 7, places=6)
        # Gent: E = 0.0981 (56 + 7.62336 S) / (0.137505 (254 - 2.54 S)) MPa.
        by_shore_a = [row for row in silicones if row["silicone"] is None and row["shore_hardness_A"] is not None]
        self.assertEqual(len(by_shore_a), 13)
        for row in by_shore_a:
            shore = row["shore_hardness_A"]
            gent = 0.0981 * (56 + 7.62336 * shore) / (0.137505 * (254 - 2.54 * shore))
            self.assertAlmostEqual(row["youngs_modulus_MPa"], gent, delta=1e-3 * gent)

    def test_each_end_of_a_range_is_a_number_that_is_taken(self):
        """Alone: another number of the design may then be what does not go with it. The design is built and comes to rest;
        its motion, which evaluate computes too, would take long where the ends make it stiff."""
        tried = 0
        for row in rows("parameters"):
            for end in re.findall(r"(?:from|to|<=|>=) (-?[\d.]+(?:e[+-]?\d+)?)", row["range"]):
                result = run("linearise", PAPER_FINGER, "--current-A", "0.1", "--set", f"{row['key']}={end}")
                with self.subTest(f"{row['key']}={end}"):
                    self.assertNotRegex(result.stderr, rf"must (lie in|be from|be finite|be [<>])[^;]*; got {re.escape(end)}\b")
                    tried += 1
        print(f"{tried} ends of ranges")
        self.assertGreater(tried, 60)

    def test_a_table_for_people_has_every_row(self):
        for what in ("quantities", "parameters", "effects", "gauges", "magnets", "silicones", "spreads", "widths"):
            lines = run("list", what).stdout.splitlines()
            self.assertGreater(len(lines), len(rows(what)), what)
            self.assertEqual(lines[0].split(), list(rows(what)[0]))

    def test_another_word_is_refused_with_the_words(self):
        words = '"quantities", "parameters", "effects", "gauges", "magnets", "silicones", "spreads", "widths"'
        self.assert_refused(["list", "magnet"], f'list: WHAT: must be one of {words}; did you mean "magnets"?; got '
                            '"magnet" (see coilwright list --help)')
        self.assert_refused(["list"], "list: WHAT is required (see coilwright list --help)")


if __name__ == "__main__":
    unittest.main()
