import inspect
import runpy

import pytest

import coilwright as cw

EXAMPLES = {
    "first_design": "steady angle 63.6 deg, grasp force 1.12 N",
    "front_by_hand": "pareto has ",
    "own_objective": "N/kg, from 18.84",
    "camera_to_corrected_design": "quadratic_drag: drag_Nmms2_rad2 0.01",
    "force_map": "cylinders: 265.537 N, published 265.537 N",
}


@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.long) if "camera" in name else name
                                  for name in EXAMPLES])
def test_an_example_prints_what_it_is_about(name, capsys):
    runpy.run_path(f"examples/python/{name}.py", run_name="__main__")
    assert EXAMPLES[name] in capsys.readouterr().out


def test_every_public_name_has_an_example_in_its_docstring():
    for name in cw.__all__:
        if name != "__version__":
            assert ">>> " in inspect.getdoc(getattr(cw, name)), name


def test_plots_are_drawn_where_matplotlib_is_installed(finger):
    pytest.importorskip("matplotlib")
    axes = cw.simulate(finger, step=1.4, duration=0.1).plot()
    assert axes.get_ylabel() == "bending angle (deg)" and len(axes.lines[0].get_xdata()) == 51
    swept = cw.sweep(cw.Study.load("configs/studies/fastest_finger.json"), sample=5)
    assert swept.plot("mass_g", "peak_bending_speed_deg_s").get_xlabel() == "mass_g"


def test_the_version_is_that_of_the_program(program):
    assert program("--version").splitlines()[0] == f"coilwright {cw.__version__}"


def test_a_page_is_that_of_the_program(program, tmp_path):
    program("size", "configs/studies/fastest_finger.json", "--out", tmp_path, "--max-evaluations", 20, "--answer-only",
            "--quiet")
    try:
        page = cw.report(tmp_path, tmp_path / "here.html")
    except cw.InputError as error:
        pytest.skip(str(error))  # a build without what pages are drawn with
    program("report", tmp_path, "--out", tmp_path / "there.html")
    assert page.read_bytes() == (tmp_path / "there.html").read_bytes()
