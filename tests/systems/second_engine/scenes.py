"""Scenes for MuJoCo: fingers about an object, and a crawling robot. By what `coilwright export` writes of the
finger, and by the geometry of docs/theory/systems.md.

The bodies of a finger are those of actuator.xml: each has its joint at its own origin and its axis along -z; the hinge
line is at x = 0, the side that grips or lies on the ground at +x, half a bottom layer from it.
"""

import copy
import csv
import dataclasses
import json
import math
import xml.etree.ElementTree as xml

from exported import export, evaluated


@dataclasses.dataclass(frozen=True)
class Contact:
    """How stiff MuJoCo's contacts are. Approach decays within `time`, s; `damping` 1 is critical, and with more a body
    that lands does not rebound. A constraint lacks the share `give` of its force, and friction `ratio` times less.
    `coulomb`: friction is Coulomb's and not the engine's (stepper.hpp)."""
    step: float = 2e-5  # of time, s
    time: float = 1e-4
    damping: float = 1.0
    give: float = 1e-4
    ratio: float = 10.0
    coulomb: bool = False


POINT = 1e-6  # radius of a ball that stands for a point, m


def numbers(values):
    return " ".join(f"{value:.17g}" for value in values)


class Finger:
    """What the program writes of an actuator of two coils with a magnet between them."""

    def __init__(self, actuator, folder):
        export(actuator, "mjcf", folder)
        export(actuator, "workshop", folder)
        self.torque = folder / "torque.csv"
        self.design = json.loads(actuator.read_text())
        body, measured = self.design["body"], self.design["measured"]
        self.face = 0.5e-3 * body["bottom_layer_mm"]  # from the hinge line
        self.axis = 1e-3 * measured["axis_offset_mm"]
        self.density = 1130.0  # of its silicone, kg/m3: the default of docs/formats-actuator.md
        chain = xml.parse(folder / "actuator.xml")
        self.gravity = chain.find("option").get("gravity")
        self.first = chain.find("worldbody/body/body")
        tip = next(node for node in self.first.iter("site") if node.get("name") == "tip")
        self.lengths = [-self.numbers_of(node, "pos")[2] for node in self.first.findall("body")]
        self.lengths.append(-self.numbers_of(tip, "pos")[2])  # of its face
        self.coil_pitch = self.lengths[-1] - 1e-3 * body["front_length_mm"]
        self.base = 1e-3 * body["rear_length_mm"] + self.coil_pitch
        magnet = self.design["magnet"]
        volume = math.pi * magnet["radius_mm"] ** 2 * magnet["length_mm"] * 1e-9
        self.moment = magnet["remanence_T"] * volume / (4e-7 * math.pi)
        self.winding = self.column(folder / "winding.csv", 1)
        self.casting = self.column(folder / "casting.csv", 1)
        size = evaluated(actuator, 0)
        self.height, self.width = 1e-3 * size["height_mm"], 1e-3 * size["width_mm"]

    @staticmethod
    def numbers_of(node, key):
        return [float(word) for word in node.get(key).split()]

    @staticmethod
    def column(path, index):
        with open(path, newline="") as file:
            return {row[0]: float(row[index]) for row in list(csv.reader(file))[1:]}

    def links(self, prefix, mirrored):
        """The moving bodies without their shapes, named anew; mirrored at x = 0."""
        first = copy.deepcopy(self.first)
        for body in first.iter("body"):
            body.set("name", prefix + body.get("name"))
            for name in ("geom", "site"):
                for node in body.findall(name):
                    body.remove(node)
            for node in [*body.findall("joint"), *body.findall("inertial")]:
                if node.tag == "joint":
                    node.set("name", prefix + node.get("name"))
                if mirrored and node.tag == "joint":
                    node.set("axis", numbers([-value for value in self.numbers_of(node, "axis")]))
                if mirrored and node.tag == "inertial":
                    x, y, z = self.numbers_of(node, "pos")
                    node.set("pos", numbers([-x, y, z]))
        return first

    def moving(self, first):
        return list(first.iter("body"))

    def parts_of(self, segment):
        """Copper and silicone of a coil's segment, kg."""
        return 1e-3 * self.winding["copper_mass_g"], 1e-6 * self.casting[segment] * self.density

    def laden_base(self, payload_mass, payload_length):
        """Mass, inertia and centre (along, off the hinge line) of the base with a box behind it, from its rear end."""
        copper, silicone = self.parts_of("segment 1 (coil)")
        # The other coil's segment was weighed; what it was heavier than its parts, the base is taken to be, too.
        mass = (copper + silicone) * 1e-3 * self.design["measured"]["tip_segment_mass_g"] / sum(
            self.parts_of("segment 3 (coil)"))
        block = self.base * self.height * self.width * self.density  # with no room for the coil
        at_coil = self.base - 0.5 * self.coil_pitch
        along = (block * 0.5 * self.base - (block - silicone) * at_coil + copper * at_coil) / (silicone + copper)
        parts = [(payload_mass, 0.5 * payload_length, 0.5 * self.height - self.face,
                  payload_mass * (payload_length ** 2 + self.height ** 2) / 12),
                 (mass, payload_length + along, self.axis, 0.0)]  # a point on the axis, as model.segment_mass says
        total = payload_mass + mass
        centre = [sum(part[0] * part[i] for part in parts) / total for i in (1, 2)]
        inertia = sum(part[3] + part[0] * ((part[1] - centre[0]) ** 2 + (part[2] - centre[1]) ** 2) for part in parts)
        return total, inertia, centre


def scene(gravity, contact, values):
    """An empty one, its world and its contacts' properties."""
    root = xml.Element("mujoco")
    xml.SubElement(root, "compiler", angle="radian", inertiafromgeom="false", boundmass="1e-12", boundinertia="1e-16")
    xml.SubElement(root, "option", timestep=f"{contact.step}", gravity=gravity, cone="elliptic", solver="Newton",
                   tolerance="1e-14", iterations="200", impratio=f"{contact.ratio}")
    xml.SubElement(root, "size", nconmax="100", njmax="500")
    custom = xml.SubElement(root, "custom")
    for name, value in {**values, "coulomb": contact.coulomb}.items():
        xml.SubElement(custom, "numeric", name=name, data=f"{value:.17g}")
    stiff = 1.0 - contact.give
    touch = {"solref": f"{contact.time} {contact.damping}", "solimp": f"{stiff} {stiff} 1e-3 0.5 1"}
    return root, xml.SubElement(root, "worldbody"), touch


def mounted(case):
    """Of each finger the prefix of its names, the side from which it reaches inwards, and how far the plane of that is
    turned about the vertical, rad. Two are mirror images in one plane, more are the left one, turned."""
    count = case.get("fingers", 2)
    if count == 2:
        return [("left_", 1.0, 0.0), ("right_", -1.0, 0.0)]
    return [(f"finger{k}_", 1.0, 2.0 * math.pi * k / count) for k in range(count)]


def gripper(finger, case, contact):
    """The fingers, the object and its support. Two slides and a hinge keep the object in the plane of two fingers;
    between more it is free."""
    sign = 1.0 if case["polarity"] == "same" else -1.0
    fingers = mounted(case)
    root, world, touch = scene(finger.gravity, contact, {
        "current_A": case["current_A"], "load_N": case["load_N"], "friction": case["friction"],
        **{prefix + "moment_Am2": (1.0, sign)[k % 2] * finger.moment for k, (prefix, _, _) in enumerate(fingers)}})
    deep = 0.02  # of the boxes that stand for the faces, behind these
    for prefix, side, plane in fingers:
        turned = side * math.radians(case["mounting_angle_deg"])
        palm = xml.SubElement(world, "body", name=prefix + "palm", axisangle=f"0 0 1 {plane:.17g}")
        base = xml.SubElement(palm, "body", name=prefix + "base", axisangle=f"0 1 0 {turned:.17g}",
                              pos=numbers([-0.5e-3 * side * case["spacing_mm"], 0, 0]))
        first = finger.links(prefix, side < 0)
        base.append(first)
        faces = [(base, -finger.base, 0.0)]
        faces += [(body, 0.0, length) for body, length in zip(finger.moving(first), finger.lengths, strict=True)]
        for body, begin, end in faces:
            xml.SubElement(body, "geom", type="box", size=numbers([0.5 * deep, 0.01, 0.5 * (end - begin)]),
                           pos=numbers([side * (finger.face - 0.5 * deep), 0, -0.5 * (begin + end)]), contype="1",
                           conaffinity="0", friction=f"{case['friction']} 0 0", condim="3", **touch)
        # The fingertip, which touches the sides of a box.
        xml.SubElement(finger.moving(first)[-1], "geom", type="sphere", size=f"{POINT}",
                       pos=numbers([side * finger.face, 0, -finger.lengths[-1]]), contype="4", conaffinity="0",
                       friction=f"{case['friction']} 0 0", condim="3", **touch)
        # Its field points along its axis, from the base to the tip; the magnet fills its body but for two walls.
        xml.SubElement(finger.moving(first)[0], "site", name=prefix + "magnet", zaxis="0 0 -1",
                       pos=numbers([-side * finger.axis, 0, -0.5 * finger.lengths[0]]))
    width, mass = 1e-3 * case["width_mm"], 1e-3 * case["mass_g"]
    if case["shape"] == "box":
        height = 1e-3 * case["height_mm"]
        size, inertia = [0.5 * width, 0.015, 0.5 * height], mass * (width ** 2 + height ** 2) / 12
    else:
        height = width
        size, inertia = [0.5 * width], 0.4 * mass * (0.5 * width) ** 2
    below = 1e-3 * case["centre_below_palm_mm"]
    object_ = xml.SubElement(world, "body", name="object",
                           pos=numbers([1e-3 * case.get("centre_x_mm", 0.0), 0, -below]))
    xml.SubElement(object_, "inertial", pos="0 0 0", mass=f"{mass}", diaginertia=numbers([inertia] * 3))
    xml.SubElement(object_, "joint", name="object_x", type="slide", axis="1 0 0")
    if len(fingers) > 2:
        xml.SubElement(object_, "joint", name="object_y", type="slide", axis="0 1 0")
    xml.SubElement(object_, "joint", name="object_z", type="slide", axis="0 0 1")
    if len(fingers) == 2:
        xml.SubElement(object_, "joint", name="object_angle", type="hinge", axis="0 1 0")
    else:
        xml.SubElement(object_, "joint", name="object_attitude", type="ball")
    rubbing = {"friction": f"{case['friction']} 0 0", "condim": "3", **touch}
    if case["shape"] == "box":
        # Sides meet fingertips, corners meet faces and the support.
        xml.SubElement(object_, "geom", type="box", size=numbers(size), contype="0", conaffinity="4", **rubbing)
        for x, z in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
            xml.SubElement(object_, "geom", type="sphere", size=f"{POINT}", contype="2", conaffinity="1",
                           pos=numbers([x * size[0], 0, z * size[2]]), **rubbing)
    else:
        xml.SubElement(object_, "geom", type="sphere", size=numbers(size), contype="2", conaffinity="1", **rubbing)
    xml.SubElement(world, "geom", name="support", type="plane", size="1 1 1", contype="0", conaffinity="2", condim="1",
                   pos=numbers([0, 0, -below - 0.5 * height]), priority="1", **touch)
    return root


def crawler(finger, case, contact):
    """The robot, lying straight; forwards is -x. Its feet are balls of a micrometre on a plane."""
    root, world, touch = scene(finger.gravity, contact, {
        "voltage_V": case["cell_voltage_V"], "coil_resistance_Ohm": finger.winding["coil_resistance_Ohm"],
        "lead_resistance_Ohm": case["lead_resistance_Ohm"], "frequency_Hz": case["frequency_Hz"], "duty": case["duty"],
        "friction_forwards": case["friction_forwards"], "friction_backwards": case["friction_backwards"],
        "settling_periods": case["settling_periods"], "periods": case["periods"]})
    xml.SubElement(world, "geom", type="plane", size="1 1 1", pos=numbers([0, 0, -POINT]), contype="0", conaffinity="1",
                   condim="3", **touch)
    mass, inertia, (along, offset) = finger.laden_base(1e-3 * case["payload_mass_g"], 1e-3 * case["payload_length_mm"])
    length = finger.base + 1e-3 * case["payload_length_mm"]
    # Turned so that its axis, -z, points along -x and its lower side, +x, down: z is then the world's x, and -x its z.
    base = xml.SubElement(world, "body", name="base", axisangle=f"0 1 0 {0.5 * math.pi:.17g}",
                          pos=numbers([0, 0, finger.face]))
    xml.SubElement(base, "joint", name="forwards", type="slide", axis="0 0 -1")
    xml.SubElement(base, "joint", name="upwards", type="slide", axis="-1 0 0")
    xml.SubElement(base, "joint", name="pitch", type="hinge", axis="0 1 0")
    xml.SubElement(base, "inertial", pos=numbers([-offset, 0, -along]), mass=f"{mass:.17g}",
                   diaginertia=numbers([inertia] * 3))
    first = finger.links("", False)
    first.set("pos", numbers([0, 0, -length]))
    base.append(first)
    feet = [(base, 0.0), (base, length), *zip(finger.moving(first), finger.lengths, strict=True)]
    for i, (body, at) in enumerate(feet):
        xml.SubElement(body, "geom", name=f"foot{i}", type="sphere", size=f"{POINT}", contype="1", conaffinity="0",
                       pos=numbers([finger.face, 0, -at]), friction=f"{case['friction_forwards']} 0 0", condim="3",
                       priority="1", **touch)
    return root
