#!/usr/bin/env python3
"""The force between coil and magnet, and between two coils, by finite elements. usage: force.py [PATH/TO/coilwright] [--quick]

Needs gmsh and getdp (on Debian: apt-get install gmsh getdp). PATH/TO/coilwright is build/release/bin/coilwright if it is not
given. --quick stops after the answer; without it mesh, boundary, gaps and iron follow. The code is 1 if the answer's rows
are not within the bounds that stand in ANSWER_BOUNDS.

Three routes to each force: J x B over the coil, Maxwell's stress in a layer of air round the magnet, and virtual work: the
current times the change of the flux through the coil as the other body moves, on other meshes.
"""

import argparse
import pathlib
import sys
from dataclasses import replace

import iron
from program import Program
from finite_elements import INSTALL, Case, fields_of, missing_tools
from recoil import force_and_slope

ROOT = pathlib.Path(__file__).resolve().parents[2]
RECOIL = 1.05  # of N52 and of every other grade in docs/theory/magnetics.md
STEP = 0.15  # of the gap, for the virtual work, mm: the fourth power of it over the size of the parts is lost
COILS = Case(remanence=0, current=1.4, second_current=1.4)
GAPS = (0.3, 0.6, 0.9, 1.5, 3, 6, 12)

# Largest difference of program and J x B, %. Without recoil both solve the same equations: 0.1, a hundred times what the
# finest mesh leaves. With recoil the program has one figure for push and pull, which differ by 0.15 %.
ANSWER_BOUNDS = {"rigid": 0.1, "recoil": 0.15, "coils": 0.1}


def percent(value: float, reference: float) -> str:
    return f"{100 * (value / reference - 1):+.3f}"


def by_virtual_work(cases: list[tuple[Case, float]]) -> list[float]:
    """Axial force on what moves by `move` times the change of the gap, N, for each (case, move).

    It is I times the slope of (flux through the first coil at I + flux at 0) / 2, a central difference of five points: the
    second coil's current stays, and what the first coil and the magnet have by themselves does not depend on the place.
    """
    shifts = (-2, -1, 1, 2)
    fluxes = fields_of([replace(case, gap=case.gap + k * STEP, current=current)
                        for case, _ in cases for k in shifts for current in (case.current, 0)])
    halves = [(a["linkage_coil"] + b["linkage_coil"]) / 2 for a, b in zip(fluxes[::2], fluxes[1::2])]
    forces = []
    for (case, move), i in zip(cases, range(0, len(halves), 4)):
        one, two, three, four = halves[i:i + 4]
        forces.append(case.current * (one - 8 * two + 8 * three - four) / (12 * move * STEP / 1000))
    return forces


def answer(program: Program) -> bool:
    """The cases of the paper; true if each is within its bound."""
    rigid, recoiling = Case(), Case(recoil=RECOIL)
    coils = replace(COILS, fineness=2)  # the weakest force needs the finest mesh
    fields = fields_of([rigid, recoiling, replace(recoiling, current=1.4), coils])
    work = by_virtual_work([(rigid, 1), (recoiling, 1), (COILS, 2)])
    rows = [
        ("rigid", "coil, magnet, recoil 1", "2.05", program.rigid(0.9), -fields[0]["lorentz_coil"],
         fields[0]["stress_magnet"], work[0]),
        ("recoil", "coil, magnet, recoil 1.05", "2.05", program.recoiling(0.9), -fields[1]["lorentz_coil"],
         fields[1]["stress_magnet"], work[1]),
        ("coils", "coil, coil", "0.024", program.coils(0.9), fields[3]["lorentz_coil"], None,
         -work[2]),
    ]
    print("The answer: force in N at 0.9 mm of gap and 1.4 A. The magnet is repelled, the second coil attracted.")
    print(f"{'':<27}{'paper':>7}{'coilwright':>12}{'J x B':>10}{'stress':>10}{'work':>10}{'coilwright - J x B, %':>23}"
          f"{'bound':>7}")
    kept = True
    for key, name, paper, model, lorentz, stress, energy in rows:
        off = 100 * (model / lorentz - 1)
        kept = kept and abs(off) <= ANSWER_BOUNDS[key]
        tension = "-" if stress is None else f"{stress:.5f}"
        print(f"{name:<27}{paper:>7}{model:>12.5f}{lorentz:>10.5f}{tension:>10}{energy:>10.5f}{off:>+23.3f}"
              f"{ANSWER_BOUNDS[key]:>7}")
    first, slope = force_and_slope()
    mean = (-fields[1]["lorentz_coil"] + fields[2]["lorentz_coil"]) / 2
    print(f"\nWith recoil {RECOIL} the same current attracts with {fields[2]['lorentz_coil']:.4f} N; the mean of both is "
          f"{mean:.4f} N, {percent(mean, -fields[0]['lorentz_coil'])} % from the rigid magnet's.")
    print(f"Without finite elements (recoil.py): rigid {first:.5f} N, with {RECOIL} {first / (1 - (RECOIL - 1) * slope):.4f} "
          f"N: inner field weighted by the coil's gradient {-slope:.3f} M;")
    print(f"coilwright's force is {percent(program.recoiling(0.9), mean)} % from that mean.")
    return kept


def ladder(program: Program) -> None:
    steps = [(order, fineness) for order in (1, 2) for fineness in (0.25, 0.5, 1, 2)]
    meshes = [(order, fineness, case) for order, fineness in steps for case in (Case(), COILS)]
    fields = fields_of([replace(case, order=order, fineness=fineness) for order, fineness, case in meshes])
    truth, weak = program.rigid(0.9), program.coils(0.9)
    print("\nThe mesh: order and size of the elements; difference from coilwright in %")
    print(f"{'':>43}{'coil, magnet, recoil 1':>24}{'coil, coil':>22}")
    print(f"{'order':>5}{'at coil, mm':>13}{'at edge, mm':>13}{'unknowns':>12}{'J x B':>12}{'stress':>12}{'J x B':>12}{'N':>10}")
    for (order, fineness), field, coils in zip(steps, fields[::2], fields[1::2]):
        print(f"{order:>5}{1 / fineness:>13g}{0.15 / fineness:>13g}{field['unknowns']:>12}"
              f"{percent(-field['lorentz_coil'], truth):>12}{percent(field['stress_magnet'], truth):>12}"
              f"{percent(coils['lorentz_coil'], weak):>12}{coils['lorentz_coil']:>10.5f}")


def boundary(program: Program) -> None:
    cases = [("shell to infinity from 60 mm", Case(far=60, outside=90)), ("shell to infinity from 90 mm", Case()),
             ("shell to infinity from 120 mm", Case(far=120, outside=170)),
             *((f"wall at {wall} mm", Case(far=far, outside=wall, to_infinity=False))
               for far, wall in ((40, 50), (60, 90), (90, 130), (200, 300)))]
    fields = fields_of([case for _, case in cases])
    truth = program.rigid(0.9)
    print("\nThe outer boundary: the same in %")
    print(f"{'':<32}{'J x B':>10}{'stress':>10}")
    for (name, _), field in zip(cases, fields):
        print(f"{name:<32}{percent(-field['lorentz_coil'], truth):>10}{percent(field['stress_magnet'], truth):>10}")


def gaps(program: Program) -> None:
    fields = fields_of([Case(gap=gap, recoil=recoil) for gap in GAPS for recoil in (1.0, RECOIL)])
    print("\nForce over gap at 1.4 A, N; differences coilwright - J x B in %")
    print(f"{'gap, mm':>7}{'recoil 1: J x B':>17}{'coilwright':>12}{'%':>8}{'recoil 1.05: J x B':>21}{'coilwright':>12}{'%':>8}")
    for i, gap in enumerate(GAPS):
        rigid, recoiling = (-field["lorentz_coil"] for field in fields[2 * i:2 * i + 2])
        one, other = program.rigid(gap), program.recoiling(gap)
        print(f"{gap:>7}{rigid:>17.5f}{one:>12.5f}{percent(one, rigid):>8}{recoiling:>21.5f}{other:>12.5f}"
              f"{percent(other, recoiling):>8}")


def report(program: Program, quick: bool) -> bool:
    kept = answer(program)
    if not quick:
        ladder(program)
        boundary(program)
        gaps(program)
        iron.report(program)
    return kept


def main() -> int:
    parser = argparse.ArgumentParser(description="The force between coil and magnet by finite elements")
    parser.add_argument("program", nargs="?", default=str(ROOT / "build/release/bin/coilwright"))
    parser.add_argument("--quick", action="store_true", help="only the answer")
    options = parser.parse_args()
    if missing := missing_tools():
        print(f"force.py: {' and '.join(missing)}: must be installed ({INSTALL})", file=sys.stderr)
        return 2
    if not pathlib.Path(options.program).is_file():
        print(f"force.py: {options.program}: must be the program; scripts/coilwright.sh --version builds it",
              file=sys.stderr)
        return 2
    try:
        kept = report(Program(options.program), options.quick)
    except (RuntimeError, OSError) as fault:  # a tool or the program refuses; what it said is the message
        print(f"force.py: {fault}", file=sys.stderr)
        return 2
    if not kept:
        print("force.py: a row of the answer is outside its bound", file=sys.stderr)
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
