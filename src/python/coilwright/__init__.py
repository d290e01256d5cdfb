"""Coilwright in Python: size soft electromagnetic bending actuators, and correct their model from measurements.

The interface is the library's, in Python's habits. Numbers whose name ends in a unit are in it (`gap_mm`); others are SI
(`current`, A). What is wrong with an input raises InputError, with the line that the program prints. All objects are
immutable, can be copied and pickled where that makes sense, and be used from several threads; Ctrl-C is heard.

>>> import coilwright as cw
>>> finger = cw.Actuator.prototype()
>>> round(cw.evaluate(finger.replace(gap_mm=0.6), current=1.4).mass_g)
67
"""

try:
    from coilwright import _core
except ImportError as error:
    if "shared object" not in str(error):
        raise
    raise ImportError(f"{error}; the Debian package coilwright brings the libraries that the module needs") from error

from coilwright._actuator import Actuator
from coilwright._core import version as __version__
from coilwright._diagnosis import Diagnosis, Estimate, Plan, Records, diagnose, plan, report, twin
from coilwright._effects import Effect, Number, effects
from coilwright._errors import InputError, NoPerformance, OutputError
from coilwright._evaluations import evaluate_all
from coilwright._films import Tracked, track
from coilwright._force import Field, Forces, Pair, field, force
from coilwright._motion import Motion, simulate
from coilwright._performance import Performance, evaluate
from coilwright._predictions import predict, score
from coilwright._results import Front, Progress, Sized, Swept, pareto, size, sweep
from coilwright._search import Found, search
from coilwright._study import Quantity, Study
from coilwright._systems import crawl, drive, grip, linearise, reach, yield_of
from coilwright._tables import Table

__all__ = [
    "Actuator", "Diagnosis", "Effect", "Estimate", "Field", "Forces", "Found", "Front", "InputError", "Motion",
    "NoPerformance", "Number", "OutputError", "Pair", "Performance", "Plan", "Progress", "Quantity", "Records", "Sized",
    "Study", "Swept", "Table", "Tracked", "__version__", "crawl", "diagnose", "drive", "effects", "evaluate", "evaluate_all",
    "field", "force", "grip", "linearise", "pareto", "plan", "predict", "reach", "report", "score", "search",
    "simulate", "size", "sweep", "track", "twin", "yield_of",
]
