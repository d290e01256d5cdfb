"""Forces between magnets against figures that others have published, and a map of them."""

# %% Cubes against the finite elements (ANSYS) that magpylib holds its own force to: tests/test_FEM.py of magpylib-force,
# where a cube of 5 moves one of 0.3, both magnetised along z with 1 T. Lengths in mm here, so forces are 1e6 smaller.
import numpy as np

import coilwright as cw


def cube(size: float, z: float) -> dict[str, object]:
    return {"magnet": {"size_mm": [size, size, size], "remanence_T": 1}, "position_mm": [0, 0, z]}


cubes = cw.Pair.from_dict({"bodies": [cube(5, 0), cube(0.3, 10)]})
places_mm = np.array([[2, 1, 7], [4, 1, 7], [2, 3, 10], [4, 3, 10]])
published = np.array([[-188.54, -92.90, -314.00], [-196.94, -45.73, -94.02],
                      [-30.15, -48.08, -66.25], [-44.47, -32.47, -36.96]])
ours = cw.force(cubes, places_mm).force_N[:, 1] * 1e6
error = np.linalg.norm(ours - published, axis=1) / np.linalg.norm(ours, axis=1)
print(f"cubes: {100 * error.min():.1f} to {100 * error.max():.1f} % from finite elements (magpylib: below 4 %)")
assert error.max() < 0.04

# %% Cylinders that repel, 50 mm apart, against MagCode for MATLAB (matlab/testsuite/testcyl01.m).
def cylinder(radius: float, length: float, z: float, up: int) -> dict[str, object]:
    return {"magnet": {"radius_mm": radius, "length_mm": length, "remanence_T": 1.3}, "position_mm": [0, 0, z],
            "axis": [0, 0, up]}


for lower, upper, newtons in (((20, 40), (20, 40), 265.537), ((20, 40), (15, 30), 111.490), ((20, 20), (20, 10), 18.953)):
    pair = cw.Pair.from_dict({"bodies": [cylinder(*lower, 0, 1), cylinder(*upper, 50, -1)]})
    force_N = cw.force(pair).force_N[0, 1, 2]
    print(f"cylinders: {force_N:.3f} N, published {newtons:.3f} N")
    assert abs(force_N - newtons) < 1e-3  # the published digits

# %% A map: the upper cylinder anywhere in a plane, as one call.
x, z = np.meshgrid(np.linspace(-60, 60, 61), np.linspace(45, 100, 56))
upwards_N = cw.force(pair, np.column_stack([x.ravel(), 0 * x.ravel(), z.ravel()])).force_N[:, 1, 2].reshape(x.shape)
print(f"map of {x.size} places: {upwards_N.min():.2f} to {upwards_N.max():.2f} N")
