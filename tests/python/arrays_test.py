"""Arrays of every kind on their way into the package."""

import datetime
import decimal

import numpy as np
import pytest

import coilwright as cw

COUNT = 10
STEPS = np.arange(COUNT)
NOON = np.datetime64("2024-02-28T12:00:00")
SECONDS = {"W": 604800.0, "D": 86400.0, "h": 3600.0, "m": 60.0, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9, "ps": 1e-12}
NAMES = {"s": 1.0, "ms": 1e3, "us": 1e6, "min": 1 / 60, "h": 1 / 3600}


def columns(time, name="time_s", **more):
    return {name: time, "current_A": np.ones(len(time)), "bending_angle_deg": np.arange(float(len(time))), **more}


def seen(time, name="time_s"):
    return cw.Records.of({"push": columns(time, name)})["push.csv"][name]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("unit", SECONDS)
def test_a_duration_of_any_unit_is_a_time_in_the_unit_of_its_name(unit, name):
    expected = STEPS * SECONDS[unit] * NAMES[name]
    assert np.allclose(seen(STEPS.astype(f"timedelta64[{unit}]"), f"time_{name}"), expected, rtol=1e-15, atol=0)


@pytest.mark.parametrize("unit", [each for each in SECONDS if each != "ps"])
def test_a_stamp_of_any_unit_counts_from_the_first(unit):
    stamps = NOON.astype(f"datetime64[{unit}]") + STEPS.astype(f"timedelta64[{unit}]")
    assert np.allclose(seen(stamps), STEPS * SECONDS[unit], rtol=1e-15, atol=0)


def test_months_count_by_the_calendar():
    assert np.array_equal(seen(np.array(["2024-01", "2024-02", "2024-03"], "datetime64[M]")), [0, 31 * 86400, 60 * 86400])


CLOCK = [datetime.datetime(2024, 1, 1) + datetime.timedelta(milliseconds=10 * int(i)) for i in STEPS]
ZONES = [datetime.timezone(datetime.timedelta(hours=int(i % 3))) for i in STEPS]


@pytest.mark.parametrize("time", [
    [datetime.timedelta(milliseconds=10 * int(i)) for i in STEPS],
    CLOCK,
    np.array(CLOCK, object),
    [each.replace(tzinfo=datetime.timezone.utc).astimezone(zone) for each, zone in zip(CLOCK, ZONES)],
    [np.timedelta64(10 * int(i), "ms") for i in STEPS],
    np.array([np.timedelta64(10_000 * int(i), "us") for i in STEPS], object),
    np.ma.array((10 * STEPS).astype("timedelta64[ms]"), mask=np.zeros(COUNT, bool)),
    [decimal.Decimal("0.01") * int(i) for i in STEPS],
    (0.01 * STEPS).astype(">f8"), (0.01 * STEPS).astype(np.longdouble), (0.01 * STEPS)[:, None], list(0.01 * STEPS),
])
def test_whatever_holds_a_time_holds_the_same_time(time):
    assert np.allclose(seen(time), 0.01 * STEPS, rtol=1e-15, atol=0)


@pytest.mark.parametrize("dtype", ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", "f8", "O"])
def test_numbers_of_any_type_are_those_of_the_name(dtype):
    assert np.array_equal(seen(STEPS.astype(dtype)), STEPS)
    assert np.array_equal(seen(STEPS.astype(dtype), "time_ms"), STEPS)


@pytest.mark.parametrize("make", [
    lambda pd: pd.to_timedelta(10 * STEPS, unit="ms"),
    lambda pd: pd.Series(pd.to_timedelta(10 * STEPS, unit="ms")),
    lambda pd: pd.date_range("2024-01-01", periods=COUNT, freq="10ms"),
    lambda pd: pd.Series(pd.date_range("2024-03-31", periods=COUNT, freq="10ms", tz="Europe/Berlin")),
    lambda pd: [pd.Timestamp("2024-01-01") + pd.Timedelta(milliseconds=10 * int(i)) for i in STEPS],
    lambda pd: [pd.Timedelta(milliseconds=10 * int(i)) for i in STEPS],
    lambda pd: pd.array(0.01 * STEPS, dtype="Float64"),
    lambda pd: pd.DataFrame({"time_s": 0.01 * STEPS})["time_s"],
])
def test_what_pandas_has_of_times_is_the_same_time(make):
    assert np.allclose(seen(make(pytest.importorskip("pandas"))), 0.01 * STEPS, rtol=1e-15, atol=0)


def test_the_nanoseconds_of_pandas_are_kept():
    pd = pytest.importorskip("pandas")
    time = [pd.Timestamp("2024-01-01") + pd.Timedelta(int(i), "ns") for i in STEPS]
    assert np.allclose(seen(time), 1e-9 * STEPS, rtol=1e-15, atol=0)


def test_a_motion_under_durations_is_that_under_seconds(finger):
    time = 10 * STEPS
    expected = cw.simulate(finger, input={"time_s": time / 1000, "current_A": np.ones(COUNT)}).rows
    for same in (time.astype("timedelta64[ms]"), NOON + time.astype("timedelta64[ms]")):
        assert np.array_equal(cw.simulate(finger, input={"time_s": same, "current_A": np.ones(COUNT)}).rows, expected)


def with_(values, row, value):
    out = np.array(values)
    out[row] = value
    return out


ABSENT = r"must have its numbers in every row: leave out row 4 \(index 3\)"


@pytest.mark.parametrize("name, values, text", [
    ("time_s", with_(STEPS.astype("timedelta64[ms]"), 3, "NaT"), ABSENT),
    ("time_s", with_(NOON + STEPS.astype("timedelta64[ms]"), 3, "NaT"), ABSENT),
    ("time_s", with_(0.01 * STEPS, 3, np.nan), ABSENT),
    ("time_s", np.ma.array(0.01 * STEPS, mask=STEPS == 3), ABSENT),
    ("time_s", np.ma.array(STEPS.astype("timedelta64[ms]"), mask=STEPS == 3), ABSENT),
    ("time_s", [None if i == 3 else i for i in STEPS], ABSENT),
    ("current_A", np.ma.array(np.ones(COUNT), mask=STEPS == 3), ABSENT),
    ("current_A", np.ma.array(np.ones(COUNT, int), mask=STEPS == 3), ABSENT),
    ("current_A", with_(np.ones(COUNT), 3, np.nan), ABSENT),
    ("time_s", STEPS.astype("timedelta64"), r"must be durations in a unit that has a length"),
    ("time_s", STEPS.astype("timedelta64[M]"), r"must be durations in a unit that has a length"),
    ("time_s", [f"{i}" for i in STEPS], "must be numbers, in the unit at the end of its name; got an array of <U1"),
    ("time_s", [datetime.date(2024, 1, 1 + int(i)) for i in STEPS], "must be numbers.* got objects of date"),
    ("time_s", [datetime.time(1, 2, int(i)) for i in STEPS], "must be numbers.* got objects of time"),
    ("time_s", [CLOCK[0], *(each.replace(tzinfo=ZONES[1]) for each in CLOCK[1:])], "must be numbers.* got objects of datetime"),
    ("time_s", STEPS * 1j, "must be numbers.* got an array of complex128"),
    ("time_s", np.ones((COUNT, 2)), r"must be one column; got shape \(10, 2\)"),
    ("time_s", [[0, 1], [2]], "must be an array"),
    ("current_A", STEPS.astype("timedelta64[ms]"), r".*only a column that is called time_s.* got an array of timedelta64\[ms\]"),
    ("current_A", NOON + STEPS.astype("timedelta64[ms]"), ".*only a column that is called time_s"),
    ("bending_angle_deg", CLOCK, ".*only a column that is called time_s"),
])
def test_what_is_no_such_number_is_refused_in_one_line(finger, name, values, text):
    given = {**columns(0.01 * STEPS), name: values}
    for call, file in ((lambda: cw.Records.of({"push": given}), "push.csv"), (lambda: cw.simulate(finger, input=given), "input")):
        with pytest.raises(cw.InputError, match=f"^{file}: {name}: {text}") as caught:
            call()
        assert "\n" not in str(caught.value) and caught.value.file == file and caught.value.place == name


@pytest.mark.parametrize("measured", [
    np.ma.array(STEPS + 0.5, mask=STEPS == 3), np.ma.array(STEPS, mask=STEPS == 3), with_(STEPS + 0.5, 3, np.nan),
    [None if i == 3 else i for i in STEPS],
])
def test_a_masked_sample_of_what_is_measured_is_an_empty_field(measured):
    text = cw.Records.of({"push": columns(0.01 * STEPS, bending_angle_deg=measured)})["push.csv"].text
    rows = [line.split(",")[2] for line in text.splitlines()[1:]]
    assert [place for place, field in enumerate(rows) if field == ""] == [3]


def test_a_masked_pose_is_refused():
    magnet = {"magnet": {"radius_mm": 5, "length_mm": 4, "remanence_T": 1.2}}
    pair = cw.Pair.from_dict({"bodies": [{**magnet, "position_mm": [0, 0, 0]}, {**magnet, "position_mm": [0, 0, 9]}]})
    places = np.array([[0, 0, 9.0], [0, 0, 12.0]])
    for masked, text in (((places, None), None), ((np.ma.array(places, mask=[[0, 0, 0], [0, 1, 0]]), None), r"positions_mm: .*row 2 \(index 1\)"),
                         ((places, np.ma.array([0, 0, 1.0], mask=[0, 0, 1])), "axes: must have its numbers"),
                         ((places.astype("timedelta64[ms]"), None), "positions_mm: must be numbers")):
        if text is None:
            assert cw.force(pair, *masked).force_N.shape == (2, 2, 3)
            continue
        with pytest.raises(ValueError, match=text):
            cw.force(pair, *masked)


@pytest.mark.parametrize("value", [np.timedelta64(100, "ns"), np.timedelta64(100, "ms"), datetime.timedelta(seconds=1),
                                   np.datetime64("2024-01-01"), np.ma.masked])
def test_a_duration_or_nothing_in_place_of_a_number_is_refused(finger, value):
    for call in (lambda: cw.simulate(finger, step=1.0, duration=value), lambda: cw.evaluate(finger, current=value),
                 lambda: finger.replace(gap_mm=value)):
        with pytest.raises(TypeError, match="^(duration|current|gap_mm): must be a number"):
            call()


@pytest.mark.parametrize("names, text", [
    (["../evil"], "must be a plain file name"), (["/tmp/evil"], "must be a plain file name"), ([".."], "must be a plain file name"),
    (["."], "must be a plain file name"), ([""], "must be a plain file name"), (["a/b"], "must be a plain file name"),
    (["a\\b"], "must be a plain file name"), (["a\nb"], "must be one line"), (["a\x00b"], "must be one line"),
    (["a", "a.csv"], "must not be there twice"), (["Push", "push"], 'must differ from "Push" by more than capitals'),
    (["x" * 300], "must have at most 255 bytes"),
])
def test_names_that_are_no_files_of_the_folder_are_refused_before_anything_is_written(tmp_path, names, text):
    with pytest.raises(cw.InputError, match=f"^records: a run {text}") as caught:
        cw.Records.of({name: columns(0.01 * STEPS) for name in names}).save(tmp_path / "set")
    assert "\n" not in str(caught.value)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("file", ["../evil.csv", "dataset.json", "Actuator.json", "push.csv"])
def test_a_file_that_about_names_keeps_the_same_rule(file):
    runs = {"push": columns(0.01 * STEPS), "pull": columns(0.01 * STEPS)}
    with pytest.raises(cw.InputError, match="^records: a run must "):
        cw.Records.of(runs, about={"pull": {"file": file}})
    with pytest.raises(cw.InputError, match="^records: a run must "):
        cw.Records({}, {"../evil.csv": "time_s\n"})
