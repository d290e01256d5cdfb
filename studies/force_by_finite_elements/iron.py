"""What mild steel beside the pair does to the force: three places, several distances.

With iron there are two effects. The force that the current makes between coil and magnet changes, and no longer equally
on both, because the iron takes the difference. And the iron pulls the magnet, with the coil switched off, too. The parts
are told apart by reversing the current: what reverses with it is the current's.
"""

import math
from dataclasses import replace

from finite_elements import Case, Iron, fields_of
from program import COIL, HALVES, MAGNET, Program

GAP = 0.9
BASE = Case(recoil=1.05, second_coil=False, far=120, outside=170)
COIL_FACE = -COIL["length_mm"] / 2
MAGNET_FACE = HALVES + GAP + MAGNET["length_mm"] / 2
PLATE, THICK = 50, 5  # radius of the plate; thickness of plate and ring, mm
DISTANCES = (2, 5, 10, 20, 30, 40, 60)

PLACES = {
    "plate behind the coil": lambda d: Iron(0, PLATE, COIL_FACE - d - THICK, COIL_FACE - d),
    "plate behind the magnet": lambda d: Iron(0, PLATE, MAGNET_FACE + d, MAGNET_FACE + d + THICK),
    "tube round both": lambda d: Iron(10 + d, 10 + d + THICK, COIL_FACE, MAGNET_FACE),
}


def parts(cases: list[Case]) -> list[dict]:
    """Of each case: what the current does to coil and magnet, N, and what pulls the magnet without it, N along +z."""
    fields = fields_of([c for case in cases for c in (case, replace(case, current=-case.current))])
    return [{"coil": -(a["lorentz_coil"] - b["lorentz_coil"]) / 2,
             "magnet": (a["stress_magnet"] - b["stress_magnet"]) / 2,
             "pull": (a["stress_magnet"] + b["stress_magnet"]) / 2,
             "rest": max(abs(f["lorentz_coil"] + f["stress_magnet"] + f["stress_iron"]) for f in (a, b)),
             "iron_T": max(f.get("iron_T", 0.0) for f in (a, b))} for a, b in zip(fields[::2], fields[1::2])]


def images(program: Program, behind: str, d: float) -> tuple[float, float]:
    """An infinitely wide plate of infinite permeability, magnet without recoil: change of the current's force on the
    coil as a part of it, and pull on the magnet, N. Such a plate is a mirror for the field."""
    near = HALVES + GAP
    if behind == "coil":
        image, own = near + 2 * (d - COIL_FACE), 2 * (d - COIL_FACE + near)
        sign = -1
    else:
        own = 2 * (d + MAGNET["length_mm"] / 2)
        image, sign = near + own, 1
    change = sign * program.rigid(image - HALVES) / program.rigid(GAP)
    return change, sign * -program.force(own, magnets=[MAGNET, MAGNET])


def distance_for(values: list[float], limit: float) -> str:
    """Where the last of `values` over DISTANCES above `limit` crosses it, mm, between two of them as a power."""
    above = [i for i, value in enumerate(values) if value > limit]
    if not above:
        return f"below {DISTANCES[0]} mm"
    i = above[-1]
    if i + 1 == len(DISTANCES):
        return f"beyond {DISTANCES[-1]} mm"
    slope = math.log(values[i + 1] / values[i]) / math.log(DISTANCES[i + 1] / DISTANCES[i])
    return f"{DISTANCES[i] * (limit / values[i]) ** (1 / slope):.0f} mm"


def report(program: Program) -> None:
    (free,) = parts([BASE])
    print(f"\nIron: {THICK} mm of mild steel (relative permeability 1000), magnet of recoil 1.05, no second coil. Without iron "
          f"{free['coil']:.4f} N on either.")
    print("Change of the current's force in %, on the coil and on the magnet; pull of the iron on the magnet without current,")
    print("N along +z; largest flux density in the iron; what the forces on coil, magnet and iron leave of zero, N")
    for place, iron_at in PLACES.items():
        found = parts([replace(BASE, iron=iron_at(d)) for d in DISTANCES])
        shape = f", radius {PLATE} mm" if "plate" in place else ", as long as both"
        print(f"\n{place}{shape}")
        print(f"{'distance, mm':>12}{'coil, %':>10}{'magnet, %':>11}{'pull, N':>10}{'iron, T':>9}{'left, N':>9}")
        changes, pulls = [], []
        for d, part in zip(DISTANCES, found):
            coil, magnet = (100 * (part[key] / free[key] - 1) for key in ("coil", "magnet"))
            pull = part["pull"] - free["pull"]
            changes.append(max(abs(coil), abs(magnet)))
            pulls.append(abs(pull))
            print(f"{d:>12}{coil:>+10.2f}{magnet:>+11.2f}{pull:>+10.4f}{part['iron_T']:>9.2f}{part['rest']:>9.4f}")
        print(f"1 % of the force: its change falls below it at {distance_for(changes, 1)}, the pull at "
              f"{distance_for(pulls, 0.01 * free['coil'])}.")
    check(program)


def check(program: Program) -> None:
    """The same against mirror images, which need no finite elements."""
    print("\nAgainst a mirror, a plate without end and of infinite permeability (coilwright force with the images), recoil 1;")
    print("finite elements: radius 110 mm, relative permeability 1e5")
    print(f"{'10 mm behind':>14}{'coil, %':>10}{'mirror':>9}{'pull, N':>10}{'mirror':>10}")
    base = replace(BASE, recoil=1.0)
    walls = [Iron(0, 110, COIL_FACE - 10 - THICK, COIL_FACE - 10, 1e5),
             Iron(0, 110, MAGNET_FACE + 10, MAGNET_FACE + 10 + THICK, 1e5)]
    free, *found = parts([base, *(replace(base, iron=wall) for wall in walls)])
    for behind, part in zip(("coil", "magnet"), found):
        change, pull = images(program, behind, 10)
        print(f"{behind:>14}{100 * (part['coil'] / free['coil'] - 1):>+10.3f}{100 * change:>+9.3f}"
              f"{part['pull'] - free['pull']:>+10.4f}{pull:>+10.4f}")
    # how little it matters what the steel is
    kinds = [replace(BASE, iron=replace(PLACES["plate behind the magnet"](10), permeability=mu)) for mu in (200, 1000, 5000)]
    free, *found = parts([BASE, *kinds])
    print("Plate 10 mm behind the magnet, relative permeability 200, 1000, 5000: pull "
          + ", ".join(f"{p['pull'] - free['pull']:.4f}" for p in found) + " N")
