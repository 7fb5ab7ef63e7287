"""A scenario rendered again, in this process and after unrelated ones, gives the same bytes.

Eleven that between them use most stages that draw at random; all of them, ten bundles each, are compared by
``python -m tests.benchmark.determinism``. For Filament see ``tests/integration/test_filament_order.py``.
"""

from collections.abc import Callable

import pytest

from sim.world import Snapshot
from tests.benchmark.determinism import content_digest
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
    assert content_digest(first_bundles([name])[name]) == content_digest(bundles_of(name))
