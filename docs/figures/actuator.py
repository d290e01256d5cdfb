#!/usr/bin/env python3
"""Draws docs/figures/actuator.svg: the prototype finger in section, to scale, and bent at 1.4 A.

    docs/figures/actuator.py            writes actuator.svg beside this file
    docs/figures/actuator.py --check    fails if actuator.svg is not what this file would write

All lengths are read from configs/actuators/paper_finger.json; only the standard library is needed.
"""
import json
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
DESIGN = json.loads((HERE.parents[1] / "configs/actuators/paper_finger.json").read_text(encoding="utf-8"))
COIL, MAGNET, BODY, MEASURED = (DESIGN[key] for key in ("coil", "magnet", "body", "measured"))

# `coilwright evaluate configs/actuators/paper_finger.json --current-A 1.4`, joint_angles_deg, to one digit.
CURRENT_A = 1.4
JOINT_ANGLES_DEG = (32.2, 31.4)

SILICONE, SILICONE_DARK, COPPER, WIRE, MAGNET_FILL = "#dfe9ee", "#b3cad6", "#8a4b22", "#e39a5c", "#7d8794"
INK, QUIET = "#1d2733", "#5a6775"

# Geometry in mm, as include/coilwright/actuator/design/dimensions.hpp derives it: x from the rear end, y from the lower
# face.
COIL_LENGTH, COIL_RADIUS = MEASURED["coil_length_mm"], MEASURED["coil_outer_radius_mm"]
HALF_COIL = COIL_LENGTH / 2 + BODY["gap_mm"] / 3  # one third of the gap is the coil's silicone wall,
HALF_MAGNET = MAGNET["length_mm"] / 2 + 2 * BODY["gap_mm"] / 3  # two thirds are the magnet's
WIDEST = max(COIL_RADIUS, MAGNET["radius_mm"])
BOTTOM = BODY["bottom_layer_mm"]
HINGE_Y = BOTTOM / 2
AXIS_Y = BOTTOM + BODY["bottom_wall_mm"] + WIDEST
HEIGHT = AXIS_Y + WIDEST + BODY["top_wall_mm"]
JOINT_1 = BODY["rear_length_mm"] + 2 * HALF_COIL
JOINT_2 = JOINT_1 + 2 * HALF_MAGNET
COIL_2_END = JOINT_2 + 2 * HALF_COIL
LENGTH = COIL_2_END + BODY["front_length_mm"]
COIL_1_X, MAGNET_X, COIL_2_X = JOINT_1 - HALF_COIL, JOINT_1 + HALF_MAGNET, JOINT_2 + HALF_COIL


class Svg:
    """Lines of an SVG file; numbers are written with two digits so that the file is the same everywhere."""

    def __init__(self):
        self.lines = []

    def add(self, element, text=None, **attributes):
        written = "".join(f' {name.replace("_", "-")}="{self.number(value)}"' for name, value in attributes.items())
        self.lines.append(f"<{element}{written}/>" if text is None else f"<{element}{written}>{text}</{element}>")

    @staticmethod
    def number(value):
        return f"{value:.2f}".rstrip("0").rstrip(".") if isinstance(value, float) else value

    def text(self, x, y, text, kind="", **attributes):
        self.add("text", text, x=float(x), y=float(y), **({"class": kind} if kind else {}), **attributes)

    def line(self, points, **attributes):
        self.add("polyline", points=" ".join(f"{x:.2f},{y:.2f}" for x, y in points), fill="none", **attributes)

    def dimension(self, start, end):
        """A dimension line with an arrow head at each end."""
        self.line([start, end], **{"class": "dimension", "marker-start": "url(#arrow)", "marker-end": "url(#arrow)"})


def part_rectangles(first, last):
    """Rectangles (x, y, width, height, fill) in mm of the coils and magnets between two places along the body."""
    for centre, kind in ((COIL_1_X, "coil"), (MAGNET_X, "magnet"), (COIL_2_X, "coil")):
        if not first < centre < last:
            continue
        if kind == "magnet":
            yield (centre - MAGNET["length_mm"] / 2, AXIS_Y - MAGNET["radius_mm"], MAGNET["length_mm"],
                   2 * MAGNET["radius_mm"], MAGNET_FILL)
        else:
            thickness = COIL_RADIUS - COIL["inner_radius_mm"]
            for low in (AXIS_Y - COIL_RADIUS, AXIS_Y + COIL["inner_radius_mm"]):
                yield centre - COIL_LENGTH / 2, low, COIL_LENGTH, thickness, "url(#turns)"


SEGMENTS = ((0.0, JOINT_1), (JOINT_1, JOINT_2), (JOINT_2, LENGTH))


def straight_view(svg, left, top, scale):
    """The section with both joints straight, the rear end at the left; callouts carry the key names."""
    def x(mm):
        return left + scale * mm

    def y(mm):
        return top + scale * (HEIGHT - mm)

    def box(px, py, width, height, **attributes):
        svg.add("rect", x=x(px), y=y(py + height), width=scale * width, height=scale * height, **attributes)

    box(0, BOTTOM, LENGTH, HEIGHT - BOTTOM, fill=SILICONE)
    box(0, 0, LENGTH, BOTTOM, fill=SILICONE_DARK)
    box(0, 0, LENGTH, HEIGHT, fill="none", stroke=INK, stroke_width=1.5)
    for first, last in SEGMENTS:
        for px, py, width, height, fill in part_rectangles(first, last):
            box(px, py, width, height, fill=fill, stroke=INK, stroke_width=1.0)
    for joint in (JOINT_1, JOINT_2):
        svg.line([(x(joint), y(HEIGHT)), (x(joint), y(BOTTOM))], stroke=INK, stroke_width=2.4)
        svg.add("circle", cx=x(joint), cy=y(HINGE_Y), r=5.0, fill="#ffffff", stroke=INK, stroke_width=1.8)
    svg.line([(x(-1.2), y(AXIS_Y)), (x(LENGTH + 1.2), y(AXIS_Y))], **{"class": "axis"})

    # Lengths along the body, above it.
    row = top - 22
    spans = ((0, BODY["rear_length_mm"]), (COIL_1_X - COIL_LENGTH / 2, COIL_1_X + COIL_LENGTH / 2),
             (MAGNET_X - MAGNET["length_mm"] / 2, MAGNET_X + MAGNET["length_mm"] / 2), (COIL_2_END, LENGTH))
    for start, end in spans:
        svg.dimension((x(start), row), (x(end), row))
        for edge in (start, end):
            svg.line([(x(edge), row - 6), (x(edge), top - 2)], **{"class": "extension"})
    svg.text(x(BODY["rear_length_mm"] / 2), row - 10, f"rear_length_mm {BODY['rear_length_mm']}", "key middle")
    svg.text(x(COIL_1_X), row - 10, f"turns_axial {COIL['turns_axial']}", "key middle")
    svg.text(x(COIL_2_END + BODY["front_length_mm"] / 2), row - 10, f"front_length_mm {BODY['front_length_mm']}",
             "key middle")
    svg.line([(x(MAGNET_X), row - 6), (x(MAGNET_X), row - 26)], **{"class": "leader"})
    magnet_face, coil_face = MAGNET_X + MAGNET["length_mm"] / 2, COIL_2_X - COIL_LENGTH / 2
    svg.text(x(magnet_face) - 10, row - 32, f"magnet_length_mm {MAGNET['length_mm']}", "key end")
    for face, side in ((magnet_face, -1), (coil_face, 1)):
        svg.line([(x(face), row - 52), (x(face), top - 2)], **{"class": "extension"})
        svg.line([(x(face) + 20 * side, row - 46), (x(face), row - 46)],
                 **{"class": "dimension", "marker-end": "url(#arrow)"})
    svg.text(x(coil_face) + 26, row - 41,
             f'<tspan class="key">gap_mm {BODY["gap_mm"]}</tspan>, coil face to magnet face', "note")

    # Heights, inside the rear part and at the front end.
    svg.dimension((x(2.4), y(0)), (x(2.4), y(BOTTOM)))
    svg.text(x(3.4), y(HINGE_Y) + 4.5, f"bottom_layer_mm {BOTTOM}", "key")
    svg.text(x(9.6), y(20.4), "rear part", "name middle")
    svg.text(x(9.6), y(18.6), "held by the base", "note middle")
    svg.text(x(9.6), y(8.2), "silicone body", "name middle")
    svg.text(x(9.6), y(6.3), f"shore_hardness_A {BODY['shore_hardness_A']}", "key middle")
    svg.text(x(COIL_2_END + 4.5), y(20.4), "front", "name middle")
    svg.text(x(COIL_2_END + 4.5), y(18.6), "part", "name middle")
    svg.dimension((x(MAGNET_X + 1.9), y(AXIS_Y)), (x(MAGNET_X + 1.9), y(AXIS_Y - MAGNET["radius_mm"])))
    svg.text(x(MAGNET_X + 1.2), y(AXIS_Y - 5.4), f"{MAGNET['radius_mm']}", "end light")
    for centre in (COIL_1_X, COIL_2_X):
        svg.text(x(centre), y(AXIS_Y + 0.5), "coil", "name middle")
    svg.dimension((x(COIL_1_X - 4.6), y(AXIS_Y)), (x(COIL_1_X - 4.6), y(AXIS_Y - COIL["inner_radius_mm"])))
    svg.text(x(COIL_1_X - 4.0), y(AXIS_Y - 2.0), f"{COIL['inner_radius_mm']}", "")
    offset = LENGTH + 2.2
    svg.dimension((x(offset), y(HINGE_Y)), (x(offset), y(AXIS_Y)))
    svg.line([(x(JOINT_2) + 8, y(HINGE_Y)), (x(offset) + 6, y(HINGE_Y))], **{"class": "axis"})
    svg.text(x(offset) + 8, y((AXIS_Y + HINGE_Y) / 2) - 4, "h", "note")
    svg.text(x(offset) + 8, y((AXIS_Y + HINGE_Y) / 2) + 12, f"{AXIS_Y - HINGE_Y:g} mm", "note")

    # Callouts below.
    below = y(0) + 46
    def callout(column, point, name, rows):
        svg.line([point, (column + 4, below - 16)], **{"class": "leader"})
        svg.add("circle", cx=float(point[0]), cy=float(point[1]), r=2.5, fill=INK)
        svg.text(column, below, name, "name")
        for index, (text, kind) in enumerate(rows):
            svg.text(column, below + 19 * (index + 1), text, kind)

    callout(x(17.0), (x(COIL_1_X - 3), y(AXIS_Y - 7)), "coil", (
        (f"turns_radial {COIL['turns_radial']}", "key"), (f"turns_axial {COIL['turns_axial']}", "key"),
        (f"wire_gauge_AWG {COIL['wire_gauge_AWG']}", "key"),
        (f"coil_inner_radius_mm {COIL['inner_radius_mm']}", "key")))
    callout(x(37.0), (x(MAGNET_X - 1.6), y(AXIS_Y - 8.4)), "magnet", (
        (f"magnet_radius_mm {MAGNET['radius_mm']}", "key"), (f"magnet_length_mm {MAGNET['length_mm']}", "key"),
        (f"remanence_T {MAGNET['remanence_T']}", "key")))
    callout(x(54.6), (x(JOINT_2), y(HINGE_Y)), "joint", (
        ("a slit; below it the", "note"), ("bottom layer bends", "note")))


def bent_view(svg, left, top, scale):
    """The hanging finger under current: base at the top, bottom layer at the right, towards which it bends."""
    angle = 0.0
    hinge = (left, top + scale * JOINT_1)
    poses = [((left, top), 0.0, 0.0)]  # where the hinge line of a segment starts on the sheet, its place, its angle
    for start, joint_angle, length in ((JOINT_1, JOINT_ANGLES_DEG[0], JOINT_2 - JOINT_1),
                                       (JOINT_2, JOINT_ANGLES_DEG[1], LENGTH - JOINT_2)):
        angle += joint_angle
        poses.append((hinge, start, angle))
        turned = math.radians(angle)
        hinge = (hinge[0] + scale * length * math.sin(turned), hinge[1] + scale * length * math.cos(turned))
    tip = hinge

    edge = (tip[0] + 1.2 * math.sin(math.radians(angle)), tip[1] + 1.2 * math.cos(math.radians(angle)))
    svg.line([pose[0] for pose in poses] + [edge], stroke=INK, stroke_width=scale * BOTTOM + 2.4,
             stroke_linejoin="round")
    for (corner, start, turned), (first, last) in zip(poses, SEGMENTS):
        # Along the body is down, across it (from the hinge line to the axis) is left, until turned.
        svg.lines.append(f'<g transform="translate({corner[0]:.2f} {corner[1]:.2f}) rotate({90 - turned:.2f}) '
                         f'scale({scale:.2f}) translate({-start:.3f} {HINGE_Y:.3f})">')
        svg.add("rect", x=float(first), y=float(BOTTOM - 2 * HINGE_Y), width=float(last - first),
                height=float(HEIGHT - BOTTOM), fill=SILICONE, stroke=INK, stroke_width=1.2 / scale)
        for px, py, width, height, fill in part_rectangles(first, last):
            svg.add("rect", x=float(px), y=float(py - 2 * HINGE_Y), width=float(width), height=float(height),
                    fill=COPPER if fill.startswith("url") else fill, stroke=INK, stroke_width=0.8 / scale)
        svg.lines.append("</g>")
    svg.line([pose[0] for pose in poses] + [tip], stroke=SILICONE_DARK, stroke_width=scale * BOTTOM,
             stroke_linejoin="round")

    # The base that holds the rear part.
    wide = scale * HEIGHT
    svg.add("rect", x=left - wide - 8, y=top - 14.0, width=wide + 24, height=14.0, fill=QUIET)

    # A joint angle is what the faces of its slit open by.
    for index, degrees in enumerate(JOINT_ANGLES_DEG):
        corner, _, before = poses[index + 1][0], 0.0, poses[index][2]
        radius = scale * (HEIGHT - HINGE_Y) * 0.86

        def on_face(turned, distance, corner=corner):
            return (corner[0] - distance * math.cos(math.radians(turned)),
                    corner[1] + distance * math.sin(math.radians(turned)))
        a, b = on_face(before, radius), on_face(before + degrees, radius)
        svg.add("path", d=f"M{a[0]:.2f} {a[1]:.2f} A{radius:.2f} {radius:.2f} 0 0 0 {b[0]:.2f} {b[1]:.2f}",
                fill="none", stroke=INK, stroke_width=1.3, marker_start="url(#arrow)", marker_end="url(#arrow)")
        place = on_face(before + degrees / 2, radius + 26)
        svg.text(place[0], place[1] + 8, f"{degrees:.1f}°", "name middle")
        svg.add("circle", cx=corner[0], cy=corner[1], r=3.6, fill="#ffffff", stroke=INK, stroke_width=1.5)


def drawing():
    width, height = 1060, 524
    title = "The prototype actuator, configuration B, in longitudinal section and bent"
    description = (
        "Left: section to scale. From the rear end: rear part, coil, slit, magnet, slit, coil and front part in one "
        "silicone body on a continuous bottom layer, which is the hinge at each slit. "
        f"Right: hanging from its base at {CURRENT_A} A, joint angles {JOINT_ANGLES_DEG[0]} and {JOINT_ANGLES_DEG[1]} "
        "degrees.")
    svg = Svg()
    svg.add("rect", x=0.5, y=0.5, width=width - 1.0, height=height - 1.0, rx=8.0, fill="#ffffff", stroke="#d5dbe1")
    svg.text(28, 36, "Prototype (configuration B: coil, magnet, coil), both joints straight", "title")
    straight_view(svg, 40.0, 142.0, 10.0)
    svg.line([(764, 24), (764, height - 24)], stroke="#d5dbe1", stroke_width=1.2)
    svg.text(784, 36, f"Bent by {CURRENT_A} A in both coils", "title")
    bent_view(svg, 922.0, 74.0, 4.6)
    for index, note in enumerate(("The model's steady pose, hanging:", "joint angles 32.2° and 31.4°,",
                                  "bending angle, their sum, 63.6°.")):
        svg.text(784, 450 + 20 * index, note, "note")
    pitch_x = COIL_LENGTH / COIL["turns_axial"] * 10.0
    pitch_y = (COIL_RADIUS - COIL["inner_radius_mm"]) / COIL["turns_radial"] * 10.0
    origin_x = 40.0 + 10.0 * (COIL_1_X - COIL_LENGTH / 2)
    origin_y = 142.0 + 10.0 * (HEIGHT - AXIS_Y - COIL_RADIUS)
    head = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        'role="img" aria-labelledby="title description">',
        f'<title id="title">{title}</title>',
        f'<desc id="description">{description}</desc>',
        "<style>",
        f"text {{ font: 14px sans-serif; fill: {INK}; }}",
        ".title { font-size: 16px; font-weight: bold; }",
        ".name { font-weight: bold; font-size: 15px; }",
        f".key {{ font: 13.5px monospace; fill: {INK}; }}",
        f".note {{ fill: {QUIET}; }}",
        ".middle { text-anchor: middle; }",
        ".end { text-anchor: end; }",
        ".light { fill: #ffffff; }",
        f".dimension {{ stroke: {INK}; stroke-width: 1.2; }}",
        f".extension {{ stroke: {QUIET}; stroke-width: 0.8; }}",
        f".leader {{ stroke: {INK}; stroke-width: 1; }}",
        f".axis {{ stroke: {INK}; stroke-width: 1; stroke-dasharray: 9 3 2 3; }}",
        "</style>",
        "<defs>",
        '<marker id="arrow" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="7" markerHeight="7" '
        f'orient="auto-start-reverse"><path d="M0 1.5 L9.5 5 L0 8.5 z" fill="{INK}"/></marker>',
        f'<pattern id="turns" x="{origin_x:.2f}" y="{origin_y:.2f}" width="{pitch_x:.3f}" height="{pitch_y:.4f}" '
        f'patternUnits="userSpaceOnUse"><rect width="5" height="5" fill="{COPPER}"/>'
        f'<circle cx="{pitch_x / 2:.3f}" cy="{pitch_y / 2:.3f}" r="1.6" fill="{WIRE}"/></pattern>',
        "</defs>",
    ]
    return "\n".join(head + svg.lines + ["</svg>"]) + "\n"


def main():
    path = HERE / "actuator.svg"
    if sys.argv[1:] == ["--check"]:
        return 0 if path.read_text(encoding="utf-8") == drawing() else "actuator.svg is not what actuator.py writes"
    path.write_text(drawing(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
