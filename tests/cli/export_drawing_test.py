"""`coilwright export --as drawing`: both files show the actuator of the input file, by the arithmetic of this test alone."""

import json
import re
import unittest
import xml.etree.ElementTree

from program import CONFIGS, ProgramTest, run

FINGER = CONFIGS / "actuators" / "finger.json"
SVG = "{http://www.w3.org/2000/svg}"


def expected():
    """Of the finger, mm: its file says what the coil measures."""
    actuator = json.loads(FINGER.read_text())
    body, magnet, measured = actuator["body"], actuator["magnet"], actuator["measured"]
    coil_radius, coil_length = measured["coil_outer_radius_mm"], measured["coil_length_mm"]
    widest = max(coil_radius, magnet["radius_mm"])
    coil_pitch = coil_length + 2 * body["gap_mm"] / 3
    magnet_pitch = magnet["length_mm"] + 4 * body["gap_mm"] / 3
    joints = [body["rear_length_mm"] + coil_pitch, body["rear_length_mm"] + coil_pitch + magnet_pitch]
    return {"length": joints[1] + coil_pitch + body["front_length_mm"],
            "width": 2 * (widest + body["side_wall_mm"]),
            "height": body["bottom_layer_mm"] + body["bottom_wall_mm"] + 2 * widest + body["top_wall_mm"],
            "axis": measured["axis_offset_mm"] + body["bottom_layer_mm"] / 2,
            "bottom": body["bottom_layer_mm"], "joints": joints, "coil_radius": coil_radius,
            "bore": actuator["coil"]["inner_radius_mm"], "magnet_radius": magnet["radius_mm"],
            "coil_length": coil_length, "magnet_length": magnet["length_mm"], "gap": body["gap_mm"]}


def groups_of(text):
    """A DXF file as (code, value)."""
    lines = text.split("\n")
    assert len(lines) % 2 == 1 and lines[-1] == ""
    return [(int(lines[i]), lines[i + 1]) for i in range(0, len(lines) - 1, 2)]


def entities_of(text):
    """The entities as dictionaries of code to value."""
    groups = groups_of(text)
    first = groups.index((2, "ENTITIES"))
    found = []
    for code, value in groups[first + 1:]:
        if code == 0 and value == "ENDSEC":
            break
        if code == 0:
            found.append({0: value})
        else:
            found[-1][code] = value if code in (1, 8) else float(value)
    return found


class Drawing(ProgramTest):
    def setUp(self):
        super().setUp()
        self.export()

    def export(self, *options):
        result = run("export", FINGER, *options, "--as", "drawing", "--out", "out", "--force", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.svg = xml.etree.ElementTree.fromstring((self.folder / "out" / "drawing.svg").read_text())
        self.dxf = (self.folder / "out" / "drawing.dxf").read_text(encoding="ascii")

    def assert_close(self, first, second):
        self.assertEqual(len(first), len(second), (first, second))
        for a, b in zip(first, second):
            self.assertAlmostEqual(a, b, delta=1e-3)  # the calibrated coil's digits

    def title_block(self):
        """Label to value, by rows of texts; a label stands with its value on one base line, left of it."""
        notes = sorted((float(e.get("y")), float(e.get("x")), e.text or "") for e in self.svg.iter(SVG + "text") if e.get("class") == "note")
        texts = [text for _, _, text in notes[[text for _, _, text in notes].index("Name"):]]
        return dict(zip(texts[::2], texts[1::2]))

    def test_a_title_block_says_what_a_workshop_asks(self):
        first = self.title_block()
        self.assertEqual((first["Name"], first["Material"], first["Lengths"]), ("finger", "Shore 28A", "mm"))
        self.assertEqual(first["General tolerance"], "+-0.1 moulded, +-0.2 by hand")
        self.assertIn("Date, signature", first)
        in_dxf = [e[1] for e in entities_of(self.dxf) if e[0] == "TEXT" and e[8] == "NOTE"]
        for label, value in first.items():
            self.assertEqual(label != "Scale", label in in_dxf)
            self.assertTrue(label == "Scale" or value in ("", *in_dxf))
        # The same numbers are the same drawing; another number is another one.
        self.export()
        self.assertEqual(self.title_block(), first)
        self.export("--set", "gap_mm=1.1")
        self.assertNotEqual(self.title_block()["Drawing number"], first["Drawing number"])

    def test_the_title_block_lies_in_the_picture_and_on_nothing(self):
        for options in ((), ("configuration=D",), ("rear_length_mm=300",), ("configuration=A",)):
            self.export(*(word for option in options for word in ("--set", option)))
            _, _, width, height = map(float, self.svg.get("viewBox").split())
            boxes = []
            for text in self.svg.iter(SVG + "text"):
                if text.get("transform") is None and text.text:
                    size, x, y = (float(text.get(name)) for name in ("font-size", "x", "y"))
                    long = 0.55 * size * len(text.text)
                    left = x - {"middle": long / 2, "end": long}.get(text.get("text-anchor"), 0)
                    boxes.append((left, left + long, y - 0.72 * size, y, text.text))
            for i, (left, right, top, bottom, text) in enumerate(boxes):
                self.assertTrue(0 <= left and right <= width and 0 <= top and bottom <= height, (options, text))
                if text in self.title_block() or text in self.title_block().values():
                    for other in boxes[:i]:
                        self.assertFalse(left < other[1] and other[0] < right and top < other[3] and other[2] < bottom, (text, other[4]))

    def test_the_dxf_has_the_body_and_its_parts_in_mm(self):
        want, entities = expected(), entities_of(self.dxf)
        body = [e for e in entities if e[0] == "LINE" and e[8] == "BODY"]
        self.assert_close((min(e[10] for e in body), min(e[20] for e in body if e[20] >= -1e-9),
                           max(e[20] for e in body)), (0, 0, want["height"]))
        # The longitudinal section is the first view, and the four sides of its body the first lines.
        self.assert_close((body[0][11] - body[0][10], body[1][21] - body[1][20]), (want["length"], want["height"]))
        slits = [e for e in entities if e[8] == "SLIT"]
        self.assert_close([e[10] for e in slits], want["joints"])
        for slit in slits:
            self.assert_close(sorted((slit[20], slit[21])), (want["bottom"], want["height"]))
        radii = sorted(e[40] for e in entities if e[0] == "CIRCLE")
        self.assert_close(radii, sorted((want["bore"], want["coil_radius"], want["magnet_radius"])))

    def test_both_files_give_the_same_numbers(self):
        want = expected()
        in_svg = sorted(e.text.replace("⌀", "%%c") for e in self.svg.iter(SVG + "text") if e.get("class") == "dimension")
        in_dxf = sorted(e[1] for e in entities_of(self.dxf) if e[0] == "TEXT" and e[8] == "DIMENSION")
        self.assertEqual(in_svg, in_dxf)
        for number in (want["length"], want["width"], want["height"], want["axis"], want["bottom"], want["coil_length"],
                       want["magnet_length"], want["gap"], want["joints"][0], want["height"] - want["bottom"]):
            self.assertIn(f"{number:.2f}".rstrip("0").rstrip("."), in_dxf)
        for radius in (want["bore"], want["coil_radius"], want["magnet_radius"]):
            self.assertIn(f"%%c{2 * radius:g}", in_dxf)

    def test_the_svg_is_to_scale_and_fits_on_a4(self):
        want = expected()
        width, height = (float(re.fullmatch(r"([\d.]+)mm", self.svg.get(name))[1]) for name in ("width", "height"))
        self.assertLessEqual(width, 297 - 20)
        self.assertLessEqual(height, 210 - 20)
        _, _, inner_width, inner_height = map(float, self.svg.get("viewBox").split())
        scale = width / inner_width
        self.assertAlmostEqual(scale, height / inner_height, delta=1e-5 * scale)
        self.assertAlmostEqual(scale, 2, delta=1e-4)
        self.assertEqual(self.title_block()["Scale"], f"{scale:.0f}:1")
        self.assertNotIn("Scale", self.dxf)  # that is the size of the part
        body = next(e for e in self.svg.iter(SVG + "rect") if e.get("class") == "body")
        self.assert_close((float(body.get("width")), float(body.get("height"))), (want["length"], want["height"]))
        circles = sorted(float(e.get("r")) for e in self.svg.iter(SVG + "circle"))
        self.assert_close(circles, sorted((want["bore"], want["coil_radius"], want["magnet_radius"])))

    def test_every_layer_line_type_and_style_is_in_its_table(self):
        groups = groups_of(self.dxf)
        layers = {groups[i + 1][1] for i, group in enumerate(groups) if group == (0, "LAYER")}
        types = {groups[i + 1][1] for i, group in enumerate(groups) if group == (0, "LTYPE")}
        self.assertEqual({e[8] for e in entities_of(self.dxf)} - layers, set())
        self.assertEqual({value for code, value in groups if code == 6} - types, set())
        self.assertIn((1, "AC1009"), groups)
        self.assertEqual(groups[-1], (0, "EOF"))

    def test_another_program_reads_the_dxf_without_complaint(self):
        try:
            import ezdxf
        except ImportError:
            self.skipTest("ezdxf is not installed")
        document = ezdxf.readfile(self.folder / "out" / "drawing.dxf")
        self.assertEqual(document.dxfversion, "AC1009")
        self.assertEqual([str(error) for error in document.audit().errors], [])
        self.assertEqual(len(document.modelspace()), len(entities_of(self.dxf)))

    def test_numbers_do_not_stand_on_each_other(self):
        for options in ((), ("configuration=D",), ("configuration=C", "turns_axial=3", "magnet_length_mm=1.5")):
            self.export(*(word for option in options for word in ("--set", option)))
            boxes = []
            for text in self.svg.iter(SVG + "text"):
                if text.get("class") != "dimension" or text.get("transform") is not None:
                    continue
                size, x, y = (float(text.get(name)) for name in ("font-size", "x", "y"))
                width = 0.6 * size * len(text.text)  # a digit of a sans-serif font
                left = x - (width / 2 if text.get("text-anchor") == "middle" else 0)
                boxes.append((left, left + width, y - 0.72 * size, y, text.text))
            self.assertGreater(len(boxes), 8)
            for i, a in enumerate(boxes):
                for b in boxes[:i]:
                    apart = a[0] >= b[1] or b[0] >= a[1] or a[2] >= b[3] or b[2] >= a[3]
                    self.assertTrue(apart, (options, a, b))

    def test_a_large_actuator_is_drawn_smaller(self):
        self.export("--set", "configuration=D", "--set", "rear_length_mm=300")
        self.assertEqual(self.title_block()["Scale"], "1:2")
        self.assertLessEqual(float(self.svg.get("width")[:-2]), 297 - 20)


if __name__ == "__main__":
    unittest.main()
