"""Sobol indices of `yield --worth` beside those of OpenTURNS, which knows nothing of Coilwright but its `evaluate`."""

import concurrent.futures
import json
import sys
import unittest

from program import ProgramTest, run
from study import write_study

try:
    import openturns
except ModuleNotFoundError:
    print("skipped: needs python3-openturns")
    sys.exit(77)

SPREAD = {"gap_mm": {"sd": 0.05}, "magnet_length_mm": {"uniform": [-0.3, 0.3]}, "joint_stiffness_factor": {"relative_sd": 0.08}}


class OpenTurns(ProgramTest):
    def test_agrees_on_a_study(self):
        write_study(self, spread=SPREAD, operating_point={"current_A": 1.2}, objectives=[{"maximise": "steady_angle_deg"}],
                    constraints=[])
        result = run("yield", "study.json", "finger.json", "--builds", "50", "--worth", "2048", "--json", cwd=self.folder)
        ours = {row["scatter"]: row for row in json.loads(result.stdout)["scatters"]}

        def angle(deviations):
            gap, length, stiffness = deviations
            changed = run("evaluate", "finger.json", "--current-A", "1.2", "--json", "--set", f"gap_mm={0.9 + gap}",
                          "--set", f"magnet_length_mm={6 + length}", "--set", f"joint_stiffness_factor={stiffness}",
                          cwd=self.folder)
            return [json.loads(changed.stdout)["steady_angle_deg"]]

        centre = json.loads((self.folder / "finger.json").read_text())
        self.assertEqual((centre["body"]["gap_mm"], centre["magnet"]["length_mm"]), (0.9, 6))
        factor = centre.get("calibration", {}).get("joint_stiffness_factor", 1.0)
        inputs = openturns.ComposedDistribution([openturns.Normal(0, 0.05), openturns.Uniform(-0.3, 0.3),
                                                 openturns.Normal(factor, 0.08 * factor)])
        openturns.RandomGenerator.SetSeed(1)  # of the bootstrap
        size = 256
        places = openturns.SobolIndicesExperiment(
            openturns.LowDiscrepancyExperiment(openturns.SobolSequence(), inputs, size), False).generate()
        with concurrent.futures.ThreadPoolExecutor() as workers:
            angles = openturns.Sample(list(workers.map(angle, places)))
        found = openturns.SaltelliSensitivityAlgorithm(places, angles, size)
        for theirs, interval, which in ((found.getFirstOrderIndices(), found.getFirstOrderIndicesInterval(), "first"),
                                        (found.getTotalOrderIndices(), found.getTotalOrderIndicesInterval(), "total")):
            low, high = interval.getLowerBound(), interval.getUpperBound()
            for i, name in enumerate(SPREAD):
                index = ours[name][which][0]
                with self.subTest(scatter=name, index=which, theirs=theirs[i]):
                    # The two intervals have a value in common.
                    self.assertLessEqual(index["low"], high[i])
                    self.assertLessEqual(low[i], index["high"])
                    self.assertLess(high[i] - low[i], 0.8)


if __name__ == "__main__":
    unittest.main()
