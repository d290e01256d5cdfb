"""Every way to get the blocks of a gripper, a crawler and a driver in a study wrong: one line, exit code 2."""

import json
import unittest

from program import ProgramTest
from study import write_study

GRIPPER = {"width_mm": 60, "mass_g": 40, "friction": 0.8}
CRAWLER = {"friction_forwards": 0.3, "friction_backwards": 0.6}
GAP = {"gap_mm": {"lower": 0.7, "upper": 1.6}}


class SystemStudyInput(ProgramTest):
    def refused(self, message):
        self.assert_refused(["size", "study.json", "--out", "out"], "study.json: " + message)
        self.assertFalse((self.folder / "out").exists())

    def test_blocks(self):
        def gripper(**changes):
            return {"gripper": {**GRIPPER, **changes}}

        def crawler(**changes):
            return {"crawler": {**CRAWLER, **changes}}

        def wanted(name):
            return {"objectives": [{"maximise": name}]}

        for changes, message in (
            ({"gripper": 3}, "/gripper: must be an object; got 3"),
            ({"gripper": {"mass_g": 40, "friction": 1}}, "/gripper/width_mm: is missing"),
            ({"gripper": {"width_cm": 6, "mass_g": 40, "friction": 1}},
             '/gripper/width_cm: unknown key; did you mean "width_mm"?'),
            (gripper(friction=0), "/gripper/friction: must be > 0 and <= 10; got 0"),
            (gripper(mounting_angle_deg=90), "/gripper/mounting_angle_deg: must be from -89 to 89; got 90"),
            (gripper(mass_g="40"), '/gripper/mass_g: must be a number; got text "40"'),
            (gripper(mass_g=5e-4), "/gripper/mass_g: must be from 0.001 to 100000; got 0.0005"),  # as `grip` refuses it
            (gripper(shape="cone"), '/gripper/shape: must be one of "sphere", "cylinder", "box", "upright_cylinder"; got text "cone"'),
            (gripper(shape="box", height_mm=50, fingers=3), "/gripper/fingers: must be 2 unless shape is sphere or upright_cylinder; got 3"),
            (gripper(fingers=3, polarity="opposite"), "/gripper/fingers: must be even where polarity is opposite; got 3"),
            (gripper(fingers=9), "/gripper/fingers: must be from 2 to 8; got 9"),
            (gripper(fingers=3, centre_x_mm=2), "/gripper/centre_x_mm: must be from 0 to 0; got 2"),
            (gripper(shape="box"), "/gripper/height_mm: is missing"),
            (gripper(polarity="turned"), '/gripper/polarity: must be one of "same", "opposite"; got text "turned"'),
            (crawler(duty=1), "/crawler/duty: must be > 0 and < 1; got 1"),
            (crawler(friction_backwards=0), "/crawler/friction_backwards: must be > 0 and <= 10; got 0"),
            (crawler(periods=1.5), "/crawler/periods: must be a whole number; got 1.5"),
            (crawler(cell_capacity_Ah=1), '/crawler/cell_capacity_Ah: unknown key; did you mean "cell_capacity_mAh"?'),
            ({"crawler": {"friction_forwards": 0.3}}, "/crawler/friction_backwards: is missing"),
            ({"driver": {"kind": "h_bridge"}}, "/driver/voltage_V: is missing"),
            ({"driver": {"kind": "battery", "voltage_V": 4}}, '/driver/kind: must be one of "h_bridge", "cell"; got text "battery"'),
            ({"driver": {"kind": "cell", "voltage_V": 4, "frequency_Hz": 0}}, "/driver/frequency_Hz: must be from 0.1 to 1000000; got 0"),
            (wanted("driver_duty"), '/objectives/0/maximise: needs the block "driver" in the study; got text "driver_duty"'),
            ({"driver": {"kind": "cell", "voltage_V": 4}, "variables": {"gap_mm": GAP["gap_mm"], "current_share_2": {"lower": 0, "upper": 1}}},
             "/variables/current_share_2: would give coils currents of their own, and the driver drives them all alike"),
            (wanted("grip_margin"), '/objectives/0/maximise: needs the block "gripper" in the study; '
             'got text "grip_margin"'),
            ({**gripper(), **wanted("crawl_speed_mm_s")},
             '/objectives/0/maximise: needs the block "crawler" in the study; got text "crawl_speed_mm_s"'),
            ({"objectives": [{"maximise": "2 * grip_margin", "name": "double", "unit": "1"}]},
             '/objectives/0/maximise: needs the block "gripper" in the study; got text "2 * grip_margin"'),
            ({**gripper(), **wanted("grip_margn")}, "/objectives/0/maximise: must be a quantity that evaluate prints; "
             'did you mean "grip_margin"?; got text "grip_margn"'),
            ({"columns": [{"quantity": "grip_margin"}]},
             '/columns/0/quantity: needs the block "gripper" in the study; got text "grip_margin"'),
            ({"columns": ["mass_g"]}, '/columns/0: must be an object; got text "mass_g"'),
            ({"variables": {"gripper_spacing_mm": {"values": [50]}}},
             '/variables/gripper_spacing_mm: needs the block "gripper" in the study'),
            ({**gripper(), "spread": {"driver_voltage_V": {"relative_sd": 0.05}}},
             '/spread/driver_voltage_V: needs the block "driver" in the study'),
            ({**gripper(), "variables": {"gripper_spacing_m": {"values": [0.05]}}},
             '/variables/gripper_spacing_m: is not a variable of a design; did you mean "gripper_spacing_mm"?'),
            ({**gripper(), "variables": {"gripper_height_mm": {"values": [50]}}},
             '/variables/gripper_height_mm: is not a variable of a design; did you mean "gripper_width_mm"?'),
            ({**gripper(), "variables": {"gripper_friction": {"values": [0.5, 11]}}},
             "/variables/gripper_friction/values/1: must be > 0 and <= 10; got 11"),
            ({**crawler(), "variables": {"crawler_periods": {"values": [5]}}},
             "/variables/crawler_periods: is not a variable of a design"),
            ({"operating_point": {"current_of": "crawler"}},
             '/operating_point/current_of: needs the block "crawler" in the study'),
            ({**crawler(), "operating_point": {"current_of": "cell"}},
             '/operating_point/current_of: must be "crawler"; got text "cell"'),
            ({**crawler(), "operating_point": {"current_of": "crawler", "duty": 0.5}},
             "/operating_point/duty: is the crawler's, with its current"),
            ({**crawler(), "operating_point": {"current_of": "crawler"}, "spread": {"duty": {"uniform": [-0.1, 0.1]}}},
             "/spread/duty: scatters nothing: it is what the crawler gives; let crawler_duty scatter"),
            ({**crawler(), "operating_point": {"current_of": "crawler"}, "spread": {"current_A": {"relative_sd": 0.05}}},
             "/spread/current_A: scatters nothing: it is what the crawler gives; let crawler_cell_voltage_V scatter"),
            ({**crawler(), "operating_point": {"current_of": "crawler", "current_A": 1}},
             '/operating_point/current_of: cannot stand beside "current_A"'),
            ({**crawler(), "operating_point": {"current_of": "crawler"},
              "variables": {"current_A": {"lower": 0.5, "upper": 1}}},
             "/operating_point/current_of: sets the current, which is a variable of this study too"),
        ):
            write_study(self, **{"variables": GAP, **changes})
            with self.subTest(message):
                self.refused(message)

    def test_an_actuator_that_cannot_be_a_part_of_it(self):
        write_study(self, gripper=GRIPPER, crawler=CRAWLER)
        finger = json.loads((self.folder / "finger.json").read_text())
        for effect, block, message in (
            ({"id": "coil_lag", "parameters": {"time_constant_ms": 5}}, "gripper",
             "/gripper: needs an actuator without effects that have states of their own"),
            ({"id": "dry_friction", "parameters": {"torque_Nmm": 0.1}}, "crawler",
             "/crawler: needs an actuator without effects that act while it runs"),
        ):
            blocks = {"gripper": {"gripper": GRIPPER}, "crawler": {"crawler": CRAWLER}}[block]
            write_study(self, **blocks)
            self.write("finger.json", json.dumps({**finger, "effects": [effect]}))
            with self.subTest(message):
                self.refused(message)


if __name__ == "__main__":
    unittest.main()
