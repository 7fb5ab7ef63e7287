"""A scenario rendered again, in this process and after unrelated ones, gives the same bytes.

Eleven that between them use most stages that draw at random; all of them, ten bundles each, are compared by
``python -m tests.benchmark.determinism``. For Filament see ``tests/integration/test_filament_order.py``.
"""

from collections.abc import Callable

import numpy as np
import pytest

from sim.messages import extrinsics, odometry, serialize
from sim.world import Snapshot
from tests.scenarios.first_bundles import first_bundles

NAMES = (
    "second_opinion",
    "night_rain",
    "fog",
    "sun_flare",
    "exposure_swings",
    "rolling_shutter",
    "motion_blur",
    "dirty_lenses",
    "fisheye_rig",
    "busy_pavements",
    "clock_jitter",
)


@pytest.mark.parametrize("name", NAMES)
def test_the_same_bytes_come_again(name: str, bundles_of: Callable[[str], list[Snapshot]]) -> None:
    before = bundles_of(name)
    again = first_bundles([name])[name]
    for one, other in zip(before, again, strict=True):
        assert serialize(odometry(one.truth)) == serialize(odometry(other.truth))
        assert serialize(extrinsics(one.truth)) == serialize(extrinsics(other.truth))
        for frame, repeated in zip(one.frames, other.frames, strict=True):
            assert (frame.camera, frame.stamp_ns, frame.arrival_ns) == (
                repeated.camera,
                repeated.stamp_ns,
                repeated.arrival_ns,
            )
            assert np.array_equal(frame.image, repeated.image), frame.camera
