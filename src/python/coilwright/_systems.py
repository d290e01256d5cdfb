"""What commands of the program answer of one actuator: a linear model, a profile of currents, a driver, a grip, a crawl, a yield."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional, Union

import numpy as np

from coilwright import _core
from coilwright._actuator import Actuator
from coilwright._errors import core_of, number, whole
from coilwright._study import Study


def linearise(actuator: Actuator, current: Union[float, Sequence[float]]) -> dict[str, Any]:
    """The linear model of small motions about the pose that a current holds: what `coilwright linearise --json` prints,
    with x' = A x + B u, y = C x + D u and the names of states, inputs and outputs.

    current: A, in every coil, or one for each, base to tip. Raises InputError where it holds no pose.

    >>> import coilwright as cw
    >>> model = cw.linearise(cw.Actuator.prototype(), 1.0)
    >>> len(model["A"]) == len(model["states"])
    True
    """
    given: Any = current
    currents = [number("current", each) for each in (given if np.ndim(given) else [given])]
    answer: dict[str, Any] = _core.linearise(core_of(actuator, Actuator), currents)
    return answer


def reach(actuator: Actuator, angle_deg: float, *, from_current: float = 0.0, lowest_current: float = 0.0,
          highest_current: Optional[float] = None, stiffness_error_percent: float = 10.0,
          damping_error_percent: float = 10.0, pieces: int = 3) -> dict[str, Any]:
    """Profiles of the current that bring an actuator to an angle without ringing: what `coilwright reach --json` prints.

    from_current: in every coil before, A. lowest_current, highest_current: of the driver, A; the highest is otherwise what
    the wire bears. The errors are how far stiffness and damping may be off. pieces: levels before the last, 1 to 6.
    Raises InputError for an angle that no current holds.

    >>> import coilwright as cw
    >>> cw.reach(cw.Actuator.prototype(), 40, pieces=1)["format"]
    'reach/1'
    """
    return _answer(_core.reach, actuator, angle_deg=angle_deg, from_current=from_current, lowest_current=lowest_current,
                   highest_current=highest_current, stiffness_error_percent=stiffness_error_percent,
                   damping_error_percent=damping_error_percent, pieces=whole("pieces", pieces))


def drive(actuator: Actuator, *, mean_current: Optional[float] = None,  # rows:
          duty: Optional[float] = None, frequency: float = 490.0, wiring: str = "parallel", actuators: int = 1,
          coil_temperature_degC: Optional[float] = 20.0, supply_voltage: float = 24.0, decay: str = "slow",
          current_limit: Optional[float] = None, supply_resistance: float = 0.0, high_resistance_mOhm: float = 307.0,
          low_resistance_mOhm: float = 258.0, dead_time_us: float = 0.22, limit_off_time_us: float = 25.0,
          limit_blanking_us: float = 2.0, diode_voltage: Optional[float] = None, bridge_lowest: float = 6.5,
          bridge_highest: float = 45.0, bridge_peak: float = 3.6, cell_voltage: Optional[float] = None,
          cell_capacity_mAh: Optional[float] = None, cell_limit: Optional[float] = None,
          switch_resistance_mOhm: float = 50.0) -> dict[str, Any]:
    """Currents, heat and run time of coils under pulses of an H-bridge or, with a cell_voltage, of a cell behind a switch:
    what `coilwright drive --json` prints.

    Of duty (0 to 1) and mean_current (A) one is given; both look for the voltage of the bridge's supply. frequency in Hz,
    voltages in V, currents in A. coil_temperature_degC: None for coils as warm as this drive leaves them.

    >>> import coilwright as cw
    >>> answer = cw.drive(cw.Actuator.prototype(), mean_current=1.0)
    >>> 0 < answer["duty"] < 1
    True
    """
    said = locals()
    said["mean_A"] = said.pop("mean_current")
    return _answer(_core.drive, **said)


def grip(actuator: Actuator, *, current: Optional[float] = None, least_friction_up_to: float = 0.0,  # rows:
         shape: str = "sphere", width_mm: float, height_mm: Optional[float] = None, mass_g: float, friction: float,
         centre_x_mm: float = 0.0, centre_below_palm_mm: float = 16.0, mounting_angle_deg: float = 30.0,
         fingers: int = 2, spacing_mm: float = 70.0, polarity: str = "same", open_current: float = 0.0,
         acceleration_m_s2: float = 0.0, least_current_up_to: Optional[float] = None) -> dict[str, Any]:
    """What becomes of an object between fingers: what `coilwright grip --json` prints.

    shape: "sphere", "cylinder", "box" or "upright_cylinder", the last two with a height_mm. current: A, otherwise that of
    the actuator's operating point, or 1.4. Ends in InputError for an object for which the open fingers have no room.

    >>> import coilwright as cw
    >>> cw.grip(cw.Actuator.load("configs/actuators/paper_finger.json"), width_mm=60, mass_g=20, friction=0.8)["holds"]
    True
    """
    return _answer(_core.grip, **locals())


def crawl(actuator: Actuator, *,  # rows:
          friction_forwards: float, friction_backwards: float, frequency: float = 10.0, duty: float = 0.5,
          cell_voltage: float = 4.2, cell_capacity_mAh: float = 150.0, cell_limit: float = 3.0,
          lead_resistance: float = 0.12, payload_mass_g: float = 23.0, payload_length_mm: float = 30.0,
          step_ms: float = 0.1, settling_periods: int = 10, periods: int = 20) -> dict[str, Any]:
    """How an actuator crawls on the ground by pulses of a cell: what `coilwright crawl --json` prints.

    friction_forwards, friction_backwards: coefficients of a foot that slides towards the fingertip and towards the rear.
    frequency in Hz, cell_voltage in V, cell_limit in A, lead_resistance in ohm.

    >>> import coilwright as cw
    >>> finger = cw.Actuator.load("configs/actuators/paper_finger.json")
    >>> cw.crawl(finger, friction_forwards=0.3, friction_backwards=0.6, periods=2, settling_periods=1)["power_W"] > 0
    True
    """
    return _answer(_core.crawl, **locals())


def yield_of(study: Study, actuator: Actuator, *, current: Optional[float] = None, builds: int = 1000, worth: int = 0,
             seed: int = 1, threads: int = 0) -> dict[str, Any]:
    """How many builds of a design keep the limits of a study with a spread: what `coilwright yield --json` prints.

    current: A, where the study varies it; otherwise that of the actuator's operating point. builds: 10 and more, by dice of
    `seed`. worth: builds, 16 and more, of each sum by which it is said which scatter matters; 0: it is not said. Ctrl-C ends it.

    >>> import coilwright as cw
    >>> finger = cw.Actuator.load("results/reference/robust_finger/actuator.json")
    >>> cw.yield_of(cw.Study.load("configs/studies/robust_finger.json"), finger, builds=10)["builds"]
    10
    """
    made, summed = whole("builds", builds) or 0, whole("worth", worth) or 0
    if made < 10 or 0 < summed < 16:
        raise ValueError(f"builds: must be 10 or more, and worth 0, or 16 or more; got {builds} and {worth}")
    of_one = study._of(actuator)
    answer: dict[str, Any] = _core.yield_of(of_one, core_of(actuator, Actuator),
                                            None if current is None else number("current", current),
                                            made, summed,
                                            whole("seed", seed) or 0, whole("threads", threads) or 0)[0]
    return answer


def _answer(ask: Any, actuator: Actuator, **said: Any) -> dict[str, Any]:
    plain = {name: value if value is None or isinstance(value, str)
             else value if isinstance(value, int) else number(name, value) for name, value in said.items()}
    answer: dict[str, Any] = ask(core_of(actuator, Actuator), plain)
    return answer
