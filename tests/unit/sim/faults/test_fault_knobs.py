"""Every key of every fault, turned alone, changes that fault's cameras within its time, and nothing else."""

from __future__ import annotations

from typing import Any, get_args

import pytest
from pydantic import TypeAdapter

from estimator.camera import Camera
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3
from sim.faults.clock_faults import ClockOffset
from sim.faults.fault import Fault
from sim.faults.kinds import WAY, AnyFault
from sim.faults.wrong_intrinsics import WrongIntrinsics, with_true_lenses
from tests.unit.sim.faults.test_kinds import CAMERAS, drive, of, same

_PARSE: TypeAdapter[Any] = TypeAdapter(AnyFault)
OTHER = {
    **{"probability": 0.6, "gain": 2.0, "size_px": [10, 12], "sigma_ms": 20.0, "delay_ms": 90.0},
    **{"offset_ms": 40.0, "focal_percent": 5.0, "center_px": [9.0, -4.0]},
    **{"at_s": 1.5, "duration_s": 2.0},
}
TAKEN_OTHERWISE = (WrongIntrinsics, ClockOffset)  # they show in how images are taken, not on their way
KEYS = [(fault, key) for fault in WAY for key in fault.model_fields if key not in ("kind", "camera")]
UNRELATED = {"kind": "dropped", "camera": "front"}


def as_dict(fault: type[Fault]) -> dict[str, Any]:
    kind = get_args(fault.model_fields["kind"].annotation)[0]
    window = {"at_s": 1.0, "duration_s": 1.0} if "at_s" in fault.model_fields else {}
    return {"kind": kind, "camera": ["rear", "left"] if kind == "swapped" else ["rear"]} | window


def name_of(value: Any) -> str:
    return value.__name__ if isinstance(value, type) else str(value)


def test_every_key_has_another_value_to_be_turned_to() -> None:
    assert {key for _, key in KEYS} == set(OTHER)


@pytest.mark.parametrize(("fault", "key"), KEYS, ids=name_of)
def test_a_key_changes_its_cameras_within_its_time_and_nothing_else(fault: type[Fault], key: str) -> None:
    plain = as_dict(fault)
    before, after = drive(plain, UNRELATED), drive(plain | {key: OTHER[key]}, UNRELATED)
    changed = set()
    for index, (one, other) in enumerate(zip(before, after, strict=True)):
        for name in CAMERAS:
            frames = of(name, one), of(name, other)
            if len(frames[0]) != len(frames[1]) or not all(map(same, *frames)):
                changed.add((index, name))
    if fault in TAKEN_OTHERWISE:
        assert not changed
    else:
        assert changed and {name for _, name in changed} <= set(plain["camera"])
        assert all(10 <= index < 35 for index, _ in changed)  # from at_s to the later of both ends


@pytest.mark.parametrize("key", ["focal_percent", "center_px"])
def test_a_lens_fault_changes_the_lens_of_its_camera_alone(key: str) -> None:
    camera = Camera("pinhole", (64, 40), (40.0, 40.0), (31.5, 19.5))
    rig = Rig("front", {name: MountedCamera(camera, SE3()) for name in CAMERAS})
    plain = as_dict(WrongIntrinsics)
    before, after = (
        with_true_lenses(rig, [_PARSE.validate_python(each)]) for each in (plain, plain | {key: OTHER[key]})
    )
    assert [name for name in CAMERAS if before[name].camera != after[name].camera] == ["rear"]
