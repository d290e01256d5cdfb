import io

import numpy as np
import pytest

import coilwright as cw


@pytest.mark.parametrize("here, there", [
    ({"step": 1.4, "duration": 0.2}, ["--step-A", 1.4, "--duration-s", 0.2]),
    ({"sine": (0.7, 0.7, 2.0), "duration": 0.3, "interval": 0.01},
     ["--sine", 0.7, 0.7, 2.0, "--duration-s", 0.3, "--interval-s", 0.01]),
])
def test_gives_the_table_of_the_program_to_the_last_digit(finger, program, tmp_path, here, there):
    program("simulate", "configs/actuators/paper_finger.json", *there, "--out", tmp_path / "motion.csv")
    motion = cw.simulate(finger, **here)
    text = (tmp_path / "motion.csv").read_text()
    assert motion.columns == text.split("\n")[0].split(",")
    assert np.array_equal(motion.rows, np.loadtxt(io.StringIO(text), delimiter=",", skiprows=1))


def test_arrays_are_read_as_a_file_of_them_is(finger, tmp_path):
    time = np.arange(0, 0.1, 1 / 300)
    columns = {"time_s": time, "current_A": np.sin(20 * time)}
    np.savetxt(tmp_path / "input.csv", np.column_stack(list(columns.values())), "%.17g", ",", header="time_s,current_A",
               comments="")
    assert np.array_equal(cw.simulate(finger, input=columns).rows, cw.simulate(finger, input=tmp_path / "input.csv").rows)


@pytest.mark.parametrize("columns, text", [
    ({"time_s": [0, 0.1], "current_A": [0, 1, 2]}, "columns must have one length; got time_s: 2, current_A: 3"),
    ({"time_s": [0, 0.1], "current": [0, 1]}, "input: "),
    ({"time_s": [0.1, 0.1], "current_A": [0, 1]}, "input: line 3"),
])
def test_columns_that_are_wrong_are_refused(finger, columns, text):
    with pytest.raises(ValueError) as caught:
        cw.simulate(finger, input=columns)
    assert str(caught.value).startswith(text)


def test_a_frequency_that_no_sample_shows_is_refused(finger):
    with pytest.raises(ValueError, match="frequency"):
        cw.simulate(finger, sine=(1.0, 0.0, 1e6))
