"""What coilwright says of the paper's coil and magnet, by the commands that a user types."""

import json
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]

COIL = {"inner_radius_mm": 3, "outer_radius_mm": 9.5, "length_mm": 12, "turns_radial": 15, "turns_axial": 30}
MAGNET = {"radius_mm": 10, "length_mm": 6, "remanence_T": 1.44}
HALVES = (COIL["length_mm"] + MAGNET["length_mm"]) / 2  # from centre to centre, less the gap


class Program:
    def __init__(self, path: str):
        self.path = str(pathlib.Path(path).resolve())

    def call(self, *arguments: str) -> dict:
        done = subprocess.run([self.path, *arguments, "--json"], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip() or f"{self.path}: ended with code {done.returncode}")
        return json.loads(done.stdout)

    def force(self, distance: float, **pair) -> float:
        """Axial force on the second body of a pair at a distance in mm between the centres, N. Windings are uniform."""
        pose = {"position_mm": [0, 0, distance], "axis": [0, 0, 1]}
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "pair.json")
            file.write_text(json.dumps({**pair, "poses": [pose]}), encoding="utf-8")
            return self.call("force", str(file))["poses"][0]["force_N"][2]

    def rigid(self, gap: float) -> float:
        """How hard 1.4 A repel the magnet without recoil, N."""
        return self.force(gap + HALVES, coil=COIL, magnet=MAGNET, current_A=-1.4)

    def coils(self, gap: float) -> float:
        """How hard two coils with 1.4 A attract each other across the magnet's place, N."""
        return -self.force(2 * (gap + HALVES), coils=[COIL, COIL], current_A=1.4)

    def recoiling(self, gap: float) -> float:
        """How hard 1.4 A repel the prototype's magnet of N52, N: as an actuator has it."""
        finger = ROOT / "configs/actuators/finger.json"
        return self.call("evaluate", str(finger), "--current-A", "1.4", "--set", f"gap_mm={gap!r}")["axial_force_N"]
