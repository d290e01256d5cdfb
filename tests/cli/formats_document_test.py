"""docs/formats*.md: their examples run, their defaults and study names are the program's."""

import re
import unittest

from program import DATA, ProgramTest, run
from study import size_plain_finger

ROOT = DATA.parent.parent
TEXT = "\n".join(page.read_text() for page in sorted((ROOT / "docs").glob("formats*.md")))


# What is written only where a design has it.
NOT_WRITTEN = {"wire_diameter_mm", "enamel", "wire_overall_mm", "filler", "silicone", "shore_hardness_00", "youngs_modulus_MPa",
               "coercivity_kA_m", "remanence_coefficient_pct_K", "coercivity_coefficient_pct_K", "recoil_permeability", "squareness"}


def examples(kind):
    return re.findall(rf"```json {kind}\n(.*?)```", TEXT, re.DOTALL)


def value_of(default):
    """A default as JSON has it: a number, or a name."""
    try:
        return float(default)
    except ValueError:
        return default


def rows_of(section):
    """Cells of the table under `### section`."""
    table = TEXT.split(f"\n### {section}\n")[1].split("\n#")[0]
    return [[cell.strip().strip("`") for cell in line.strip("|").split("|")]
            for line in table.splitlines() if line.startswith("| `")]


class FormatsDocument(ProgramTest):
    def test_the_examples_run(self):
        for kind, arguments in (("actuator", ["evaluate", "example.json", "--current-A", "0.5"]),
                                ("pair", ["force", "example.json"])):
            for text in examples(kind):
                self.write("example.json", text)
                result = run(*arguments, cwd=self.folder)
                self.assertEqual((result.returncode, result.stderr), (0, ""))
        for number, text in enumerate(examples("study")):
            # Its path counts from docs/.
            self.write("example.json", text.replace("../configs", str(ROOT / "configs")))
            result = run("size", "example.json", "--out", f"out{number}", "--max-evaluations", "40", cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual([len(examples(kind)) for kind in ("actuator", "pair", "study")], [3, 2, 3])

    def test_the_defaults_and_study_names_are_the_program_s(self):
        written = size_plain_finger(self)
        for section in ("coil", "magnet", "body", "surroundings"):
            rows = rows_of(section)
            # A coil's share of the current is written where it is not the whole.
            written[section] = {**{key: 1.0 for key, *_ in rows if key.startswith("current_share_")},
                                **{key: value_of(default) for key, default, *_ in rows if key in NOT_WRITTEN},
                                **written[section]}
            self.assertEqual({key: value_of(default) for key, default, *_ in rows}, written[section])
            for key, default, name, _ in rows:
                if key in NOT_WRITTEN and default == "none" and key != "silicone":
                    continue  # a number that names otherwise what another one names
                with self.subTest(name):
                    result = run("evaluate", "plain.json", "--current-A", "0.5", "--set",
                                 f"{name}={written[section][key]}", cwd=self.folder)
                    self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual({key: default for key, default, _ in rows_of("model")}, written["model"])
        # What has no default is not written.
        self.assertEqual({key: float(default) for key, default, _ in rows_of("calibration") if default != "none"},
                         written["calibration"])


if __name__ == "__main__":
    unittest.main()
