import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import pytest

import coilwright as cw

FASTEST = "configs/studies/fastest_finger.json"
FRONT = "configs/studies/speed_against_grip.json"


def same_files(here, there, names):
    for name in names:
        assert (here / name).read_bytes() == (there / name).read_bytes(), name


def test_size_writes_the_bytes_of_the_program(program, tmp_path):
    program("size", FASTEST, "--out", tmp_path / "there", "--max-evaluations", 30, "--quiet")
    found = cw.size(cw.Study.load(FASTEST), max_evaluations=30)
    found.write(tmp_path / "here")
    same_files(tmp_path / "here", tmp_path / "there",
               ["result.json", "actuator.json", "evaluations.csv", "convergence.csv"])
    assert found.to_dict() == json.loads((tmp_path / "there/result.json").read_text())
    assert found.best == cw.Actuator.load(tmp_path / "there/actuator.json")
    speed = cw.evaluate(found.best).peak_bending_speed_deg_s
    assert speed == found.to_dict()["best"]["objectives"]["peak_bending_speed_deg_s"]
    assert "peak_bending_speed_deg_s" in found.text and found._repr_html_().startswith("<p>")


def test_pareto_writes_the_bytes_of_the_program_on_any_number_of_threads(program, tmp_path):
    program("pareto", FRONT, "--out", tmp_path / "there", "--max-evaluations", 60, "--quiet", "--threads", 2)
    front = cw.pareto(cw.Study.load(FRONT), max_evaluations=60, threads=1)
    front.write(tmp_path / "here")
    same_files(tmp_path / "here", tmp_path / "there",
               ["front.csv", "result.json", "evaluations.csv", "convergence.csv"])
    assert len(list(front)) == len(front.table()) == len(front)
    first = front.table()[0]
    assert cw.evaluate(front[0]).grasp_force_N == first["grasp_force_N"]
    with pytest.raises(IndexError):
        front[len(front)]


def test_sweep_writes_the_bytes_of_the_program(program, tmp_path):
    program("sweep", FASTEST, "--out", tmp_path / "there", "--sample", 12, "--quiet")
    swept = cw.sweep(cw.Study.load(FASTEST), sample=12)
    swept.write(tmp_path / "here")
    same_files(tmp_path / "here", tmp_path / "there", ["designs.csv", "best.csv", "result.json"])
    assert swept.table().to_frame().shape == (12, len(swept.table().columns))


def test_a_study_with_another_number_of_objectives_is_refused():
    with pytest.raises(cw.InputError, match=r"/objectives: must be one for size \(pareto takes two or three\); got 2"):
        cw.size(cw.Study.load(FRONT))


def test_quantities_of_python_are_objectives_and_limits(finger):
    study = {"format": "study/1", "name": "own", "operating_point": {"current_A": 1.0},
             "variables": {"turns_radial": {"lower": 8, "upper": 18}, "gap_mm": {"lower": 0.6, "upper": 1.5}},
             "objectives": [{"maximise": "grip_per_mass_N_kg"}],
             "constraints": [{"quantity": "twice_mass_g", "at_most": 140}]}
    own = [cw.Quantity("grip_per_mass_N_kg", lambda p: p.grasp_force_cold_N / p.mass_g * 1000, scale=15),
           cw.Quantity("twice_mass_g", lambda p: 2 * p.mass_g)]
    found = cw.size(cw.Study.from_dict(study, finger, quantities=own), max_evaluations=40, answer_only=True)
    best = cw.evaluate(found.best)
    assert found.feasible and best.mass_g <= 70
    said = found.to_dict()["best"]["objectives"]["grip_per_mass_N_kg"]
    assert said == best.grasp_force_cold_N / best.mass_g * 1000
    ours = cw.Study.from_dict({**study, "objectives": [{"maximise": "grasp_force_cold_N / mass_g", "name": "grip", "unit": "N/g"}],
                               "constraints": [{"quantity": "mass_g", "at_most": 70}]}, finger)
    again = cw.evaluate(cw.size(ours, max_evaluations=40, answer_only=True).best)
    assert best.grasp_force_cold_N / best.mass_g == pytest.approx(again.grasp_force_cold_N / again.mass_g, rel=0.02)


def test_an_exception_of_an_own_quantity_comes_through(finger):
    def fails(performance):
        raise ZeroDivisionError("of mine")
    study = cw.Study.from_dict({"format": "study/1", "name": "own", "operating_point": {"current_A": 1.0},
                                "variables": {"gap_mm": {"lower": 0.6, "upper": 1.5}},
                                "objectives": [{"minimise": "mine"}]}, finger, quantities=[cw.Quantity("mine", fails)])
    with pytest.raises(ZeroDivisionError, match="of mine"):
        cw.size(study, max_evaluations=10)


def test_a_study_is_pickled_with_what_was_set():
    study = cw.Study.load(FASTEST, set={"/constraints/3/at_most": 60})
    again = pickle.loads(pickle.dumps(study))
    assert again.limits == study.limits and "mass_g <= 60" in again.limits


def test_ctrl_c_ends_a_search_soon():
    script = ("import coilwright as cw\n"
              f"study = cw.Study.load({FASTEST!r})\n"
              "print('begins', flush=True)\n"
              "try:\n"
              "    cw.size(study, max_evaluations=1000000)\n"
              "except KeyboardInterrupt:\n"
              "    print('interrupted')\n")
    run = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True, env=os.environ)
    assert run.stdout.readline() == "begins\n"
    time.sleep(1)
    run.send_signal(signal.SIGINT)
    assert run.communicate(timeout=60)[0] == "interrupted\n"


def test_other_threads_run_while_a_search_works():
    count = 0
    done = threading.Event()

    def counting():
        nonlocal count
        while not done.is_set():
            count += 1
            time.sleep(1e-3)
    thread = threading.Thread(target=counting)
    thread.start()
    before = count
    cw.size(cw.Study.load(FASTEST), max_evaluations=60, answer_only=True)
    assert count > before + 5
    done.set()
    thread.join()


def test_an_actuator_with_an_effect_of_python_is_sized(finger):
    softer = cw.Effect("softer", stage="hinge", description="a spring that helps", equation="q += k theta", source="of this test",
                       numbers=[cw.Number("k", "N m/rad", lower=0.0, upper=1.0, absent=0.0)], starts=[[1e-4]],
                       torques=lambda k, angles, rates, currents: k[0] * angles)
    changed = cw.Actuator.from_dict({**finger.to_dict(), "effects": [{"id": "softer", "parameters": {"k": 2e-3}}]},
                                    effects=[softer])
    assert cw.evaluate(changed, current=1).steady_angle_deg > cw.evaluate(finger, current=1).steady_angle_deg + 1
    study = cw.Study.from_dict({"format": "study/1", "name": "own", "operating_point": {"current_A": 1.0},
                                "variables": {"gap_mm": {"lower": 0.8, "upper": 1.2}},
                                "objectives": [{"maximise": "steady_angle_deg"}]}, changed, effects=[softer])
    best = cw.size(study, max_evaluations=5, answer_only=True).best
    assert best.to_dict()["effects"][0]["id"] == "softer"
    assert cw.evaluate(best).steady_angle_deg >= cw.evaluate(changed, current=1).steady_angle_deg
