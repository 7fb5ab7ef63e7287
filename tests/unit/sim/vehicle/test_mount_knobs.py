"""Every key of every mounting event, turned alone, moves that event's camera otherwise, and no other one."""

from __future__ import annotations

from typing import Any, get_args

import numpy as np
import pytest

from estimator.se3 import Array
from sim.vehicle.miscalibration import Mounts
from sim.vehicle.mount_events import AnyMountEvent, MountEvent
from tests.unit.sim.vehicle.test_mount_events import KNOCK, mounts_of

EVENTS: tuple[type[MountEvent], ...] = get_args(get_args(AnyMountEvent)[0])
PLAIN = {"duration_s": 3.0, "period_s": 7.0, "frequency_hz": 11.0}
OTHER = {
    **{"duration_s": 2.0, "period_s": 9.0, "frequency_hz": 13.0},
    **{"at_s": 5.0, "rotation_deg": 1.5, "translation_mm": 30.0},
}
KEYS = [(event, key) for event in EVENTS for key in event.model_fields if key not in ("kind", "camera")]
TIMES_S = np.arange(0.0, 12.0, 0.23)


def as_dict(event: type[MountEvent]) -> dict[str, Any]:
    kind = get_args(event.model_fields["kind"].annotation)[0]
    return {**KNOCK, "kind": kind} | {key: PLAIN[key] for key in PLAIN if key in event.model_fields}


def poses(mounts: Mounts, camera: str) -> Array:
    """(N, 4, 4) ``ego_from_cam`` at ``TIMES_S``."""
    found = [mounts.moved(camera, float(time_s)) or mounts.starting[camera] for time_s in TIMES_S]
    return np.stack([pose.matrix for pose in found])


def test_every_key_has_another_value_to_be_turned_to() -> None:
    assert {key for _, key in KEYS} == set(OTHER)


@pytest.mark.parametrize(("event", "key"), KEYS)
def test_a_key_moves_its_camera_from_its_time_on_and_no_other_one(event: type[MountEvent], key: str) -> None:
    unrelated = {**KNOCK, "camera": "left", "at_s": 2.0}
    plain = as_dict(event)
    before, after = mounts_of(plain, unrelated), mounts_of(plain | {key: OTHER[key]}, unrelated)
    np.testing.assert_array_equal(poses(before, "left"), poses(after, "left"))
    differ = np.abs(poses(before, "rear") - poses(after, "rear")).max(axis=(1, 2)) > 0
    assert differ.any() and not differ[plain["at_s"] > TIMES_S].any()
