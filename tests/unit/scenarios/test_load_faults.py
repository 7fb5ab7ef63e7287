"""A wrong fault is refused in one line with its path, before anything is built."""

from pathlib import Path

import pytest

from estimator.errors import InputError
from scenarios.load import load_scenario


@pytest.mark.parametrize(
    ("fault", "message"),
    [
        ("{kind: droped, camera: rear}", "faults[0].kind: got 'droped', wanted one of wrong_intrinsics,"),
        ("{camera: rear}", "faults[0].kind: missing"),
        ("{kind: off}", "faults[0].camera: missing"),
        ("{kind: off, camera: reer}", "faults[0].camera: got 'reer', wanted a camera of the rig; there are:"),
        ("{kind: off, camera: [rear, 3]}", "faults[0].camera: got ['rear', 3], wanted the name of a camera"),
        ("{kind: off, camera: rear, probability: 1}", "faults[0].probability: unknown key; there are: at_s,"),
        ("{kind: off, camera: rear, at_s: -1}", "faults[0].at_s: got -1, wanted 0 to 3600"),
        ("{kind: off, camera: rear, duration_s: 0}", "faults[0].duration_s: got 0, wanted over 0 to 3600"),
        (
            "{kind: dropped, camera: rear, probability: 1.1}",
            "faults[0].probability: got 1.1, wanted over 0",
        ),
        ("{kind: swapped, camera: rear}", "faults[0].camera: got 'rear', wanted a list"),
        ("{kind: swapped, camera: [rear, rear]}", "faults[0].camera: got ['rear', 'rear'], wanted each"),
        ("{kind: wrong_resolution, camera: rear, size_px: [9]}", "faults[0].size_px: got 1 values, wanted 2"),
        (
            "{kind: wrong_resolution, camera: rear, size_px: [9, 4097]}",
            "faults[0].size_px[1]: got 4097, wanted 8 to 4096",
        ),
        (
            "{kind: wrong_intrinsics, camera: rear, center_px: [.nan, 0]}",
            "faults[0].center_px[0]: got nan, wanted a finite number, -200 to 200",
        ),
        ("{kind: wrong_intrinsics, camera: rear, at_s: 1}", "faults[0].at_s: unknown key; there are: camera"),
        (
            "{kind: dropped, camera: rear, probabilty: 1}",
            "faults[0].probabilty: unknown key; there are: at_s, camera, duration_s, kind, probability "
            "(did you mean 'probability'?)",
        ),
        ("off", "faults[0]: got 'off', wanted keys with values"),
    ],
)
def test_a_wrong_fault_is_one_line(tmp_path: Path, fault: str, message: str) -> None:
    file = tmp_path / "mine.yaml"
    file.write_text(f"base: first_drive\nabout: Mine.\nfaults: [{fault}]\n")
    with pytest.raises(InputError) as error:
        load_scenario(str(file))
    assert str(error.value).startswith(f"{file}: ")
    assert message in str(error.value) and "\n" not in str(error.value)


def test_faults_can_be_set_on_the_command_line() -> None:
    world = load_scenario("first_drive", ["faults=[{kind: late, camera: rear, delay_ms: 90}]"]).world
    assert world.faults[0].model_dump()["delay_ms"] == 90
