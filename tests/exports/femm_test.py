"""`coilwright export --as femm`: the script draws the pair, and what it draws has the force that the program computes.

FEMM itself is a program for Windows: the script runs under Lua with stand-ins that record what it asks of FEMM. Skipped
where lua5.4 is not installed; the force of what was recorded needs gmsh and getdp as well.
"""

import json
import math
import pathlib
import re
import shutil
import subprocess
import unittest

from exported import FINGER, PAPER_FINGER, changed_finger, export, skip_without
from planar_faces import area, faces, region_of
from program import ProgramTest, run

RECORDER = pathlib.Path(__file__).with_name("record_femm.lua")
MU0 = 4e-7 * math.pi


def word(text):
    try:
        return float(text)
    except ValueError:
        return text


class Drawing:
    """What a script asked FEMM for."""

    def __init__(self, script):
        done = subprocess.run(["lua5.4", RECORDER, script], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        self.calls = [(name, tuple(map(word, arguments)))
                      for name, *arguments in (line.split("\t") for line in done.stdout.splitlines())]
        self.nodes = set(self.of("mi_addnode"))
        self.sides = [((r1, z1), (r2, z2)) for r1, z1, r2, z2 in self.of("mi_addsegment")]
        self.labels = {}
        selected = None
        for name, arguments in self.calls:
            if name == "mi_selectlabel":
                selected = arguments
            elif name == "mi_clearselected":
                selected = None
            elif name == "mi_setblockprop":
                self.labels[selected] = arguments
        self.materials = {arguments[0]: arguments[1:] for arguments in self.of("mi_addmaterial")}

    def of(self, name):
        return [arguments for called, arguments in self.calls if called == name]

    def with_arcs(self):
        """All sides, arcs as straight pieces of the length that the script asks for."""
        sides = list(self.sides)
        for r1, z1, r2, z2, angle, piece in self.of("mi_addarc"):
            assert angle == 180 and (r1, r2) == (0, 0) and z1 == -z2
            count = round(angle / piece)
            points = [(r1, z1)] + [(z2 * math.cos(math.radians(i * piece - 90)), z2 * math.sin(math.radians(i * piece - 90)))
                                   for i in range(1, count)] + [(r2, z2)]
            sides += zip(points, points[1:])
        return sides


class Femm(ProgramTest):
    def drawing(self, actuator=FINGER, current="1.4"):
        folder, _ = export(actuator, "femm", self.folder / "femm", "--current-A", current)
        return Drawing(folder / "pair.lua"), json.loads((folder / "pair.json").read_text())

    def test_it_is_a_problem_of_axial_symmetry_in_millimetres(self):
        drawing, _ = self.drawing()
        self.assertEqual(drawing.calls[0], ("newdocument", (0.0,)))
        self.assertEqual(drawing.of("mi_probdef")[0][:3], (0.0, "millimeters", "axi"))

    def test_sides_end_at_nodes_and_meet_nowhere_else(self):
        drawing, _ = self.drawing()
        for a, b in drawing.sides:
            self.assertTrue({a, b} <= drawing.nodes)
            self.assertEqual(len({a[0], b[0]}) + len({a[1], b[1]}), 3)  # along r or along z
            for r, z in drawing.nodes - {a, b}:
                on = min(a[0], b[0]) <= r <= max(a[0], b[0]) and min(a[1], b[1]) <= z <= max(a[1], b[1])
                self.assertFalse(on, f"{r, z} on {a, b}")
        self.assertGreaterEqual(min(r for r, _ in drawing.nodes), 0)

    def test_each_region_has_one_label_with_its_material(self):
        drawing, pair = self.drawing()
        regions = faces(drawing.with_arcs())
        self.assertEqual(len(regions), 4)
        self.assertEqual(set(drawing.of("mi_addblocklabel")), set(drawing.labels))
        self.assertEqual(sorted(region_of(regions, place) for place in drawing.labels), [0, 1, 2, 3])
        of = {}
        for place, properties in drawing.labels.items():
            of.setdefault(properties[0], []).append((regions[region_of(regions, place)], properties))
        self.assertEqual({name: len(found) for name, found in of.items()}, {"winding": 1, "magnet": 1, "air": 2})

        coil, magnet = pair["coil"], pair["magnet"]
        middle = pair["poses"][0]["position_mm"][2]
        half = coil["length_mm"] / 2
        self.assertEqual(set(of["winding"][0][0][0]), {(r, z) for r in (coil["inner_radius_mm"], coil["outer_radius_mm"])
                                                      for z in (-half, half)})
        corners = {(r, round(z, 9)) for r, z in of["magnet"][0][0][0]}
        half = magnet["length_mm"] / 2
        self.assertEqual(corners, {(r, round(middle + z, 9)) for r in (0, magnet["radius_mm"]) for z in (-half, half)})

        _, _, _, circuit, _, group, turns = of["winding"][0][1]
        self.assertEqual((circuit, group, turns), ("coil", 1, coil["turns_radial"] * coil["turns_axial"]))
        _, _, _, circuit, direction, group, _ = of["magnet"][0][1]
        self.assertEqual((circuit, direction, group), ("<None>", 90, 2))

    def test_materials_and_current_are_those_of_the_pair(self):
        drawing, pair = self.drawing()
        for name in ("air", "winding"):
            self.assertEqual(drawing.materials[name][:5], (1, 1, 0, 0, 0))
        mu_r, mu_z, coercivity, density, _ = drawing.materials["magnet"][:5]
        self.assertEqual((mu_r, mu_z, density), (1.05, 1.05, 0))
        self.assertAlmostEqual(MU0 * mu_z * coercivity, pair["magnet"]["remanence_T"], delta=1e-9)
        self.assertEqual(drawing.of("mi_addcircprop"), [("coil", -1.4, 1)])
        self.assertEqual(pair["current_A"], -1.4)  # against the magnet, in both

    def test_the_potential_is_zero_on_the_wall(self):
        drawing, pair = self.drawing()
        (name, *numbers), = drawing.of("mi_addboundprop")
        self.assertEqual(numbers, [0] * 9)
        (_, low, _, high, _, _), = drawing.of("mi_addarc")
        self.assertEqual(drawing.of("mi_selectarcsegment"), [(high, 0)])
        self.assertEqual(drawing.of("mi_setarcsegmentprop"), [(2.5, name, 0, 0)])
        self.assertGreater(high, 20 * max(pair["coil"]["outer_radius_mm"], pair["magnet"]["radius_mm"]))
        self.assertEqual(low, -high)

    def test_it_solves_and_prints_both_forces(self):
        drawing, _ = self.drawing()
        names = [name for name, _ in drawing.calls]
        order = ["mi_saveas", "mi_analyze", "mi_loadsolution", "mo_groupselectblock", "mo_blockintegral", "print"]
        self.assertEqual(sorted(order, key=names.index), order)
        after = drawing.calls[names.index("mi_loadsolution") + 1:]
        self.assertEqual(after[:6], [("mo_groupselectblock", (2,)), ("mo_blockintegral", (19,)), ("mo_clearblock", ()),
                                     ("mo_groupselectblock", (1,)), ("mo_blockintegral", (12,)), ("mo_clearblock", ())])
        self.assertRegex(after[-1][1][0], r"N, away from the coil: by stress 1\.5, by J x B -1\.5$")

    def test_it_uses_nothing_that_lua_4_does_not_have(self):
        folder, _ = export(FINGER, "femm", self.folder / "femm")
        code = re.sub(r'"[^"]*"|--.*', "", (folder / "pair.lua").read_text())
        for token in ("#", "//", "%", "[[", "string.", "math.", "table.", "io.", ":", "local", "goto", "pairs", "{"):
            self.assertNotIn(token, code)

    def test_a_path_of_two_lines_is_no_command(self):
        design = changed_finger(self.folder).rename(self.folder / "finger\nremove().json")
        drawing, _ = self.drawing(design)
        self.assertEqual(drawing.calls[0][0], "newdocument")
        self.assertIn("/finger\\nremove().json.\n", (self.folder / "femm" / "pair.lua").read_text())

    def test_finite_elements_on_what_it_draws_give_the_program_s_force(self):
        if shutil.which("gmsh") is None or shutil.which("getdp") is None:
            self.skipTest("gmsh or getdp not installed")
        drawing, _ = self.drawing(PAPER_FINGER)
        found = force_by_elements(drawing, self.folder)
        result = run("force", self.folder / "femm" / "pair.json", "--json")
        expected = json.loads(result.stdout)["poses"][0]["force_N"][2]
        # The wall at 30 sizes is worth 0.002 % (studies/force_by_finite_elements), the mesh 0.02 %.
        self.assertAlmostEqual(found, expected, delta=5e-4 * expected)


PROBLEM = """
Group {{ Coil = Region[1]; Magnet = Region[2]; Air = Region[3]; Zero = Region[4]; All_ = Region[{{Coil, Magnet, Air}}]; }}
Function {{
  nu[Region[{{Coil, Air}}]] = 1 / {mu0}; nu[Magnet] = 1 / ({mu0} * {mu});
  hc[] = Vector[0, {coercivity}, 0]; j[] = Vector[0, 0, {density}];
}}
Jacobian {{ {{ Name V; Case {{ {{ Region All; Jacobian VolAxiSqu; }} }} }} }}
Integration {{ {{ Name I; Case {{ {{ Type Gauss; Case {{ {{ GeoElement Triangle; NumberOfPoints 12; }} }} }} }} }} }}
Constraint {{ {{ Name Z; Case {{ {{ Region Zero; Value 0; }} }} }} }}
FunctionSpace {{ {{ Name S; Type Form1P;
  BasisFunction {{
    {{ Name n; NameOfCoef a; Function BF_PerpendicularEdge; Support All_; Entity NodesOf[All]; }}
    {{ Name e; NameOfCoef b; Function BF_PerpendicularEdge_2E; Support All_; Entity EdgesOf[All]; }} }}
  Constraint {{ {{ NameOfCoef a; EntityType NodesOf; NameOfConstraint Z; }}
                {{ NameOfCoef b; EntityType EdgesOf; NameOfConstraint Z; }} }} }} }}
Formulation {{ {{ Name F; Type FemEquation; Quantity {{ {{ Name a; Type Local; NameOfSpace S; }} }}
  Equation {{
    Integral {{ [ nu[] * Dof{{d a}}, {{d a}} ]; In All_; Jacobian V; Integration I; }}
    Integral {{ [ -hc[], {{d a}} ]; In Magnet; Jacobian V; Integration I; }}
    Integral {{ [ -j[], {{a}} ]; In Coil; Jacobian V; Integration I; }} }} }} }}
Resolution {{ {{ Name R; System {{ {{ Name A; NameOfFormulation F; }} }}
  Operation {{ Generate[A]; Solve[A]; SaveSolution[A]; PostOperation[P]; }} }} }}
PostProcessing {{ {{ Name Q; NameOfFormulation F; Quantity {{ {{ Name f; Value {{
  Integral {{ [ -2 * Pi * CompY[j[] /\\ {{d a}}] ]; In Coil; Jacobian V; Integration I; }} }} }} }} }} }}
PostOperation {{ {{ Name P; NameOfPostProcessing Q; Operation {{ Print[f[Coil], OnGlobal, Format Table, File "force.txt"]; }} }} }}
"""


def force_by_elements(drawing, folder):
    """Force on the magnet, N, away from the coil: FEMM's problem as drawn, solved by gmsh and GetDP."""
    regions = faces(drawing.with_arcs())
    points, lines, geometry = {}, {}, []

    def point(place, size):
        if place not in points:
            points[place] = len(points) + 1
            geometry.append(f"Point({points[place]}) = {{{place[0]!r}, {place[1]!r}, 0, {size}}};")
        return points[place]

    def loop(ends, size):
        words = []
        for a, b in zip(ends, ends[1:] + ends[:1]):
            if (b, a) in lines:
                words.append(-lines[b, a])
                continue
            if (a, b) not in lines:
                first, second = point(a, size), point(b, size)
                lines[a, b] = len(lines) + 1
                geometry.append(f"Line({lines[a, b]}) = {{{first}, {second}}};")
            words.append(lines[a, b])
        geometry.append(f"Curve Loop({len(geometry) + 1000}) = {{{', '.join(map(str, words))}}};")
        return len(geometry) - 1 + 1000

    kinds = {"winding": [], "magnet": [], "air": []}
    for place, properties in sorted(drawing.labels.items(), key=lambda item: item[1][2]):  # the finest first
        outer, holes = regions[region_of(regions, place)]
        loops = [loop(ends, properties[2]) for ends in [outer, *holes]]
        kinds[properties[0]].append(len(geometry) + 1)
        geometry.append(f"Plane Surface({len(geometry) + 1}) = {{{', '.join(map(str, loops))}}};")
    for number, surfaces in enumerate(kinds.values(), 1):
        geometry.append(f"Physical Surface({number}) = {{{', '.join(map(str, surfaces))}}};")
    geometry.append("Physical Curve(4) = CombinedBoundary{ Surface{:}; }; Mesh.ScalingFactor = 1e-3;")
    (folder / "drawn.geo").write_text("\n".join(geometry) + "\n")

    (_, current, _), = drawing.of("mi_addcircprop")
    place, turns = next((place, properties[6]) for place, properties in drawing.labels.items() if properties[0] == "winding")
    section = area(regions[region_of(regions, place)][0]) * 1e-6
    _, mu, coercivity = drawing.materials["magnet"][:3]
    # A positive current of FEMM runs with the angle, which is -z of GetDP's frame.
    (folder / "drawn.pro").write_text(PROBLEM.format(mu0=repr(MU0), mu=mu, coercivity=coercivity,
                                                     density=repr(-turns * current / section)))
    for command in (["gmsh", "-2", "-v", "2", "-format", "msh22", "drawn.geo", "-o", "drawn.msh"],
                    ["getdp", "drawn.pro", "-msh", "drawn.msh", "-solve", "R", "-v", "2"]):
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120, check=False)
        said = done.stdout + done.stderr
        assert done.returncode == 0 and not re.search(r"^Error", said, re.MULTILINE), said[-2000:]
    return float((folder / "force.txt").read_text().split()[1])


if __name__ == "__main__":
    skip_without([] if shutil.which("lua5.4") else ["lua5.4"])
    unittest.main()
