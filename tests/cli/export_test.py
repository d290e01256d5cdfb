"""`coilwright export`: what it writes and says, and every way to ask wrongly."""

import html.parser
import json
import math
import unittest

from program import CONFIGS, DATA, ProgramTest, run

FINGER = CONFIGS / "actuators" / "finger.json"


class Export(ProgramTest):
    def test_it_names_the_files_that_it_wrote_and_what_to_do_with_them(self):
        result = run("export", FINGER, "--as", "workshop", "--out", "sheets/", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        *names, use = result.stdout.splitlines()
        self.assertEqual(sorted(names), sorted(name for name, content in self.files().items() if content is not None))
        self.assertRegex(use, r"\.$")

    def test_coils_with_shares_of_the_current_are_told(self):
        split = ("--set", "current_share_2=0.5")
        lumped = run("export", FINGER, "--as", "lumped", "--out", "lumped", *split, cwd=self.folder)
        self.assertIn("the shares of the operating current that the coils carry, 1 and 0.5 from base to tip", lumped.stdout + lumped.stderr)
        run("export", FINGER, "--as", "workshop", "--out", "sheets", *split, cwd=self.folder)
        page = (self.folder / "sheets" / "workshop.html").read_text(encoding="utf-8")
        self.assertIn("A of which the coils, base to tip, carry 1 and 0.5 on drivers of their own for good", page)
        self.assertIn("an H-bridge board for each coil", page)

    def test_an_unknown_kind_is_refused_with_those_that_there_are(self):
        result = run("export", FINGER, "--as", "banana", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout, self.files()), (2, "", {}))
        self.assertRegex(result.stderr, r'^coilwright: export: --as: must be one of "workshop", .*; got "banana" .*\n$')

    def test_a_lumped_model_has_nothing_to_build(self):
        lumped = DATA / "formats" / "lumped_model.json"
        self.assert_refused(["export", str(lumped), "--as", "workshop", "--out", "out"],
                            f"{lumped}: workshop needs the geometry of a design (actuator/1)")

    def test_a_setting_outside_its_bounds_is_refused(self):
        self.assert_refused(["export", str(FINGER), "--as", "workshop", "--out", "out", "--lead-mm", "-1"],
                            'export: --lead-mm: must be from 0 to 10000; got "-1" (see coilwright export --help)')

    def test_a_setting_of_another_kind_is_refused(self):
        self.assert_refused(["export", str(FINGER), "--as", "mould", "--out", "out", "--lead-mm", "100"],
                            "--lead-mm: is no setting of mould")

    def test_the_input_is_not_written_over(self):
        self.write("winding.csv", FINGER.read_text())
        self.assert_refused(["export", "winding.csv", "--as", "workshop", "--out", "."],
                            "./winding.csv: cannot be written: it is an input of this command")

    def test_an_edited_file_is_kept(self):
        """Parts in OpenSCAD are there to be changed by hand."""
        command = ["export", FINGER, "--as", "mould", "--out", "out"]
        self.assertEqual(run(*command, cwd=self.folder).returncode, 0)
        self.assertEqual(run(*command, cwd=self.folder).returncode, 0)  # nothing of it changes
        edited = sorted((self.folder / "out").glob("*.scad"))[0]
        edited.write_text(edited.read_text() + "// mine\n")
        self.assert_refused(command, f"out/{edited.name}: cannot be written: it holds something else; --force replaces it, "
                                     "another --out keeps it")
        self.assertIn("// mine", edited.read_text())
        self.assertEqual(run(*command, "--force", cwd=self.folder).returncode, 0)
        self.assertNotIn("// mine", edited.read_text())

    def test_the_silicone_s_parts_are_told_where_their_ratio_is(self):
        run("export", FINGER, "--as", "workshop", "--out", "out", "--base-per-hardener", "9", cwd=self.folder)
        page = (self.folder / "out" / "workshop.html").read_text()
        batch = next(row for row in self.table("out/casting.csv") if row["what"] == "second dip")
        mixed = float(batch["mixed_g"])
        self.assertRegex(page, rf'<td class="number"[^>]*>{0.9 * mixed:.2f}</td><td class="number"[^>]*>{0.1 * mixed:.2f}</td>')

    def test_the_sheets_weigh_and_cost_what_evaluate_says(self):
        """Another route: the masses by which the actuator moves, and the cost that studies search for."""
        self.write("finger.json", '{"format": "actuator/1", "configuration": "C", "magnet": {"radius_mm": 8.5}, '
                                  '"coil": {"turns_radial": 12}}')
        run("export", "finger.json", "--as", "workshop", "--out", "out", cwd=self.folder)
        result = json.loads(run("evaluate", "finger.json", "--current-A", "1", "--json", cwd=self.folder).stdout)
        silicone = sum(float(row["in_actuator_cm3"]) for row in self.table("out/casting.csv")
                       if row["what"].startswith("segment")) * 1.13
        winding = {row["quantity"]: float(row["value"]) for row in self.table("out/winding.csv")}
        copper = winding["coils"] * winding["copper_mass_g"]
        magnets = 2 * math.pi * 0.85 ** 2 * 0.6 * 7.5
        self.assertAlmostEqual(silicone + copper + magnets, result["mass_g"], delta=1e-4 * result["mass_g"])  # six digits
        prices = {row["item"]: float(row["price_USD"]) for row in self.table("out/materials.csv")}
        self.assertAlmostEqual(sum(prices.values()) - prices["driver and supply"], result["cost_USD"], delta=1e-3)

    def test_every_element_of_the_page_is_closed(self):
        run("export", FINGER, "--as", "workshop", "--out", "out", cwd=self.folder)
        open_elements = []

        class Reader(html.parser.HTMLParser):
            def handle_starttag(self, tag, _):
                if tag not in ("meta", "br"):
                    open_elements.append(tag)

            def handle_endtag(self, tag):
                assert open_elements.pop() == tag, tag

        Reader().feed((self.folder / "out" / "workshop.html").read_text())
        self.assertEqual(open_elements, [])

    def test_a_name_cannot_become_code(self):
        finger = json.loads(FINGER.read_text())
        finger["name"] = 'x */ cube(9); // <script>alert("é")</script>'
        self.write("finger.json", json.dumps(finger))
        for kind in ("workshop", "drawing", "mould"):
            result = run("export", "finger.json", "--as", kind, "--out", "out", cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertNotIn("<script", (self.folder / "out" / "workshop.html").read_text())
        self.assertNotIn("<script", (self.folder / "out" / "drawing.svg").read_text())
        self.assertTrue(all(ord(letter) < 128 for letter in (self.folder / "out" / "drawing.dxf").read_text()))
        scad = (self.folder / "out" / "mould.scad").read_text().splitlines()
        self.assertEqual([line[:2] for line in scad if "cube(9)" in line], ["//"])

    def test_an_actuator_that_cannot_be_built_is_refused(self):
        self.assert_refused(["export", str(FINGER), "--set", "gap_mm=1200", "--as", "workshop", "--out", "out"],
                            "gap_mm=1200: must be from 0.05 to 1000")


if __name__ == "__main__":
    unittest.main()
