import copy
import pickle

import pytest

import coilwright as cw


def test_is_equal_after_a_round_through_a_dict_a_pickle_and_a_copy(finger):
    wider = finger.replace(gap_mm=1.25, configuration="C")
    for again in (cw.Actuator.from_dict(wider.to_dict()), pickle.loads(pickle.dumps(wider)), copy.deepcopy(wider)):
        assert again == wider and hash(again) == hash(wider)
        assert again != finger


def test_replace_leaves_the_old_one_as_it_was(finger):
    before = finger.to_dict()
    finger.replace(turns_axial=26)
    assert finger.to_dict() == before


def test_an_error_has_the_text_and_the_parts_of_the_program(tmp_path):
    path = tmp_path / "wrong.json"
    path.write_text('{"format": "actuator/1", "name": "x", "configuration": "B", "body": {"gap_mm": -1}}')
    with pytest.raises(cw.InputError) as caught:
        cw.Actuator.load(path)
    error = caught.value
    assert str(error) == f"{path}: /body/gap_mm: must be from 0.05 to 1000; got -1"
    assert (error.file, error.place, error.value) == (str(path), "/body/gap_mm", "-1")
    assert str(pickle.loads(pickle.dumps(error))) == str(error)


@pytest.mark.parametrize("change, text", [
    ({"gap_mm": -1.0}, "gap_mm=-1.0: must be from 0.05 to 1000"),
    ({"gap": 1.0}, "gap=1.0: "),
    ({"gap_mm": float("nan")}, "gap_mm=nan: "),
    ({"configuration": "Z"}, "configuration=Z: "),
])
def test_replace_refuses_what_the_program_refuses(finger, change, text):
    with pytest.raises(cw.InputError) as caught:
        finger.replace(**change)
    assert text in str(caught.value)


def test_a_missing_file_is_told_in_one_line():
    with pytest.raises(cw.InputError, match="^nowhere.json: cannot be opened: No such file or directory$"):
        cw.Actuator.load("nowhere.json")


def test_a_lumped_model_has_no_numbers_to_replace():
    model = cw.Actuator.load("tests/data/formats/lumped_model.json")
    assert not model.is_design
    with pytest.raises(cw.InputError, match="is a lumped model: only the numbers of a design can be replaced"):
        model.replace(gap_mm=1)
