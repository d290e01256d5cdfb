"""`coilwright export --as getdp`: finite elements on the exported files give the force that `coilwright force` gives.

Skipped where gmsh or getdp is not installed.
"""

import json
import re
import shutil
import subprocess
import unittest

from exported import FINGER, PAPER_FINGER, changed_finger, export, skip_without
from program import ProgramTest, run

# J x B on elements of second order leaves 0.01 %; a first order in the recoil of 1.05 with one figure for push and pull
# is 0.1 % off (studies/force_by_finite_elements). Maxwell's stress leaves 0.1 % on this mesh.
RIGID = 2e-4
RECOIL = 1.5e-3
STRESS = 2e-3


def call(folder, tool, *arguments):
    done = subprocess.run([tool, *arguments], cwd=folder, capture_output=True, text=True, timeout=120, check=False)
    said = done.stdout + done.stderr
    # Neither tool may be trusted to end with a code other than 0 when it stops at an error.
    assert done.returncode == 0 and not re.search(r"^Error", said, re.MULTILINE), said[-2000:]


def by_elements(folder, *settings):
    """Force on the magnet by J x B and by Maxwell's stress, N, and the coil's flux linkage, Wb."""
    call(folder, "gmsh", "-2", "-v", "2", "-format", "msh22", "pair.geo", "-o", "pair.msh", *settings)
    call(folder, "getdp", "pair.pro", "-msh", "pair.msh", "-solve", "Solve", "-v", "2", *settings)
    return [float(line.split()[1]) for line in (folder / "forces.txt").read_text().splitlines()]


def force(folder):
    """By the program, on the exported pair: force along the axis, N."""
    result = run("force", folder / "pair.json", "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)["poses"][0]["force_N"][2]


class GetDP(ProgramTest):
    def assert_same_force(self, actuator, bound, *more):
        folder, _ = export(actuator, "getdp", self.folder / "pair", *more)
        lorentz, stress, _ = by_elements(folder)
        expected = force(folder)
        self.assertAlmostEqual(lorentz, expected, delta=bound * abs(expected))
        self.assertAlmostEqual(stress, lorentz, delta=STRESS * abs(lorentz))
        first = (folder / "pair_data.pro").read_text().splitlines()[1]
        said = float(re.search(r"Coilwright: (\S+) N", first).group(1))
        self.assertAlmostEqual(said, expected, delta=1e-4 * abs(expected))  # five digits
        return expected

    def test_the_paper_s_pair_repels_with_the_force_that_the_study_found(self):
        self.assertAlmostEqual(self.assert_same_force(PAPER_FINGER, RIGID, "--current-A", "1.4"), 2.1247, delta=1e-4)

    def test_a_magnet_that_recoils(self):
        self.assertAlmostEqual(self.assert_same_force(FINGER, RECOIL, "--current-A", "1.4"), 2.0477, delta=1e-4)

    def test_a_negative_current_attracts(self):
        self.assertLess(self.assert_same_force(PAPER_FINGER, RIGID, "--current-A", "-0.7"), -1)

    def test_a_pair_of_another_shape_and_size(self):
        design = changed_finger(self.folder, measured={}, body={"gap_mm": 2.2},
                                coil={"inner_radius_mm": 1.5, "turns_radial": 6, "turns_axial": 40, "wire_gauge_AWG": 32},
                                magnet={"radius_mm": 2.5, "length_mm": 9, "grade": None, "remanence_T": 1.2})
        design = design.rename(self.folder / "a\nb.json")
        finger = json.loads(design.read_text())
        del finger["magnet"]["grade"], finger["measured"]
        design.write_text(json.dumps(finger))
        self.assert_same_force(design, RIGID)

    def test_the_gap_can_be_swept_on_the_command_line(self):
        folder, _ = export(PAPER_FINGER, "getdp", self.folder / "pair")
        pair = json.loads((folder / "pair.json").read_text())
        pair["poses"][0]["position_mm"][2] += 3.0 - 0.9
        (folder / "pair.json").write_text(json.dumps(pair))
        lorentz, _, _ = by_elements(folder, "-setnumber", "gap", "3")
        self.assertAlmostEqual(lorentz, force(folder), delta=RIGID * abs(lorentz))

    def test_the_field_is_that_of_coilwright_field(self):
        # Radius and height in mm: beyond the magnet, beside the pair, in the copper and in the magnet.
        points = [(4, 20), (12, 5), (6, 1), (5, 10.5)]
        folder, _ = export(PAPER_FINGER, "getdp", self.folder / "pair", "--current-A", "1.4")
        with open(folder / "pair.pro", "a", encoding="utf-8") as file:
            file.write("PostOperation { { Name AtPoints; NameOfPostProcessing Field; Operation {\n")
            for number, (radius, height) in enumerate(points):
                file.write(f"  Print[flux_density, OnPoint {{{radius / 1e3}, {height / 1e3}, 0}}, Format SimpleTable, "
                           f"File \"point{number}.txt\"];\n")
            file.write("} } }\n")
        fine = ("-setnumber", "fineness", "2")
        by_elements(folder, *fine)
        call(folder, "getdp", "pair.pro", "-msh", "pair.msh", "-pos", "AtPoints", "-v", "2", *fine)
        at = [word for radius, height in points for word in ("--at", radius, 0, height)]
        result = run("field", folder / "pair.json", *at, "--json")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for number, point in enumerate(json.loads(result.stdout)["points"]):
            across, along = map(float, (folder / f"point{number}.txt").read_text().split()[3:5])
            # A slope of a potential of second order: 0.07 % at worst here, 0.05 % with the next finer mesh.
            bound = 1.5e-3 * point["magnitude_mT"]
            self.assertAlmostEqual(1e3 * across, point["flux_density_mT"][0], delta=bound)
            self.assertAlmostEqual(1e3 * along, point["flux_density_mT"][2], delta=bound)

    def test_iron_pulls_a_disc_as_its_mirror_image_where_force_says_so(self):
        folder, _ = export(PAPER_FINGER, "getdp", self.folder / "pair")
        problem = (folder / "pair.pro").read_text(encoding="utf-8")
        # The coil becomes a disc of iron without a bore.
        space, iron = "nu[Region[{Coil, Within, Layer, Air, Space}]]", "nu[Coil] = 1 / (mu0 * 1000);\n  nu[Region[{Within, Layer, Air, Space}]]"
        self.assertIn(space, problem)
        (folder / "pair.pro").write_text(problem.replace(space, iron), encoding="utf-8")
        disc = {"magnet": {"radius_mm": 6.35, "length_mm": 3.175, "remanence_T": 1.32}, "position_mm": [0, 0, 0.5 + 3.175 / 2]}
        # 1 % of the pull is beyond 13 mm. The mesh leaves 0.15 % of Maxwell's stress.
        for radius, least, most in ((40, 0.997, 1.001), (12, 0.97, 0.995), (8, 0.8, 0.9)):
            self.write("plate.json", json.dumps({"bodies": [disc], "plate": {"thickness_mm": 5, "relative_permeability": 1000,
                                                                            "radius_mm": radius}}))
            result = run("force", "plate.json", "--json", cwd=self.folder)
            self.assertEqual("an endless plate's pull takes 13 mm: it pulls less" in result.stderr, radius < 13)
            (folder / "pair_data.pro").write_text(
                f"DefineConstant[ coil_inner = 0, coil_outer = {radius}, coil_length = 5, turns = 1, magnet_radius = 6.35, "
                f"magnet_length = 3.175, gap = 0.5, current = 0, size = {radius}, remanence = 1.32, recoil = 1, fineness = 1, order = 2 ];")
            _, stress, _ = by_elements(folder)
            share = stress / json.loads(result.stdout)["poses"][0]["bodies"][0]["force_N"][2]
            self.assertTrue(least < share < most, (radius, share))

    def test_a_model_without_parts_is_refused(self):
        lumped, _ = export(FINGER, "lumped", self.folder / "lumped")
        before = self.files()
        result = run("export", lumped / "lumped_model.json", "--as", "getdp", "--out", self.folder / "pair")
        self.assertEqual((result.returncode, result.stdout, self.files()), (2, "", before))
        self.assertRegex(result.stderr, r"^coilwright: .*lumped_model.json: needs a coil and a magnet by their dimensions: "
                                        r"this model has none, or torque tables alone\n$")


if __name__ == "__main__":
    skip_without([tool for tool in ("gmsh", "getdp") if shutil.which(tool) is None])
    unittest.main()
