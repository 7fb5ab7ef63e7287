"""Every setting has a range, and whatever lies outside of it is refused with path and range."""

from typing import Literal, get_args, get_origin

import pytest

from estimator.errors import InputError
from scenarios.load import load_scenario
from tests.settings import Setting, all_models, all_settings

SETTINGS = list(all_settings())
NUMBERS = [setting for setting in SETTINGS if setting.is_number]
CHOICES = [setting for setting in SETTINGS if any(get_origin(kind) is Literal for kind in setting.kinds)]


def name_of(setting: Setting) -> str:
    return f"{setting.model.__name__}.{setting.path}"


def refusal(setting: Setting, value: str) -> str:
    """Return the one line with which a value is refused."""
    with pytest.raises(InputError) as error:
        load_scenario("first_drive", [setting.set_to(value)])
    assert "\n" not in str(error.value)
    return str(error.value)


def test_the_walk_finds_settings_of_every_depth() -> None:
    paths = {setting.path for setting in SETTINGS}
    assert {"about", "drive.speed_mps", "street.traffic.cars", "faults[0].probability"} <= paths
    assert len(NUMBERS) > 40 and len(all_models()) > 15


@pytest.mark.parametrize("setting", NUMBERS, ids=name_of)
def test_every_number_has_a_range_at_both_ends(setting: Setting) -> None:
    assert setting.low is not None and setting.high is not None and setting.low < setting.high


@pytest.mark.parametrize("setting", NUMBERS, ids=name_of)
def test_a_number_out_of_range_is_refused_with_path_and_range(setting: Setting) -> None:
    assert setting.low is not None and setting.high is not None
    for value in (setting.low - 1, setting.high + 1):
        assert f": {setting.path}: got {value:g}, wanted {setting.range}" in refusal(setting, f"{value:g}")


@pytest.mark.parametrize("setting", NUMBERS, ids=name_of)
@pytest.mark.parametrize("value", [".nan", ".inf", "fast", "{}"])
def test_what_is_no_finite_number_is_refused_with_path_and_range(setting: Setting, value: str) -> None:
    text = refusal(setting, value)
    assert f": {setting.path}: got " in text and text.endswith(f"number, {setting.range}")


@pytest.mark.parametrize("setting", CHOICES, ids=name_of)
def test_what_is_no_choice_is_refused_with_all_choices(setting: Setting) -> None:
    text = refusal(setting, "no_such_choice")
    assert f"{setting.path}: got 'no_such_choice'" in text
    if not setting.path.endswith("].kind"):  # that one picks the model, so it lists other models' kinds too
        choices = [choice for kind in setting.kinds for choice in get_args(kind) if isinstance(choice, str)]
        assert all(choice in text for choice in choices)


@pytest.mark.parametrize("setting", SETTINGS, ids=name_of)
def test_an_unknown_key_beside_it_is_refused_with_those_that_there_are(setting: Setting) -> None:
    wrong = setting.path.rpartition(".")[0] + ".no_such_key"
    text = refusal(Setting(wrong.removeprefix("."), setting.model, setting.field), "1")
    assert f"{wrong.removeprefix('.')}: unknown key; there are: " in text
    assert setting.path.rpartition(".")[2] in text


@pytest.mark.parametrize("setting", SETTINGS, ids=name_of)
def test_a_misspelt_key_is_told_with_what_was_meant(setting: Setting) -> None:
    group, _, key = setting.path.rpartition(".")
    wrong = f"{group}.{key}x".removeprefix(".")
    text = refusal(Setting(wrong, setting.model, setting.field), "1")
    assert text.endswith(f"(did you mean {key!r}?)")
