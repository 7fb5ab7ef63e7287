"""Cameras whose stamps never fall together with the others'."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from estimator.bundle import FrameBundle
from estimator.bundling import Bundler, Stamped
from estimator.finding import Finding, FindingKind
from estimator.stamp_watch import StampWatch, StampWatchConfig
from tests.bags import small_rig

RIG = small_rig(dict.fromkeys(("front", "second", "left", "right", "rear"), (96, 64)))
PERIOD_MS = 100
IMAGE = np.zeros((64, 96), np.uint8)


def findings(
    late_ms: Mapping[str, float], every: Mapping[str, int] | None = None, kept: float = 1.0, seed: int = 0
) -> list[Finding]:
    """Return what is found in 50 periods of cameras with late stamps, of lower rates, with lost images."""
    rng = np.random.default_rng(seed)
    stream = [
        Stamped(int(1e6 * (k * PERIOD_MS + late_ms.get(name, 0) + rng.normal(0, 1))), name, IMAGE)
        for k in range(50)
        for name in RIG.cameras
        if k % (every or {}).get(name, 1) == 0 and rng.random() < kept
    ]
    watch = StampWatch(RIG, StampWatchConfig())
    for stamp_ns, members in Bundler(1e6 * PERIOD_MS, "front").groups(sorted(stream)):
        watch.see(FrameBundle(stamp_ns, {m.camera: m.payload for m in members}))
    return list(watch.findings())


@pytest.mark.parametrize(
    ("late_ms", "told"), [(40, "40 ms later"), (-30, "30 ms earlier"), (60, "40 ms earlier")]
)
def test_a_camera_out_of_step_is_told_by_name_and_no_other(late_ms: float, told: str) -> None:
    (finding,) = findings({"left": late_ms})
    assert (finding.kind, finding.cameras) == (FindingKind.CLOCK_OFFSET, ("left",))
    assert finding.doubtful and told in finding.about


def test_a_reference_out_of_step_is_the_one_that_is_told() -> None:
    assert [finding.cameras for finding in findings({"front": 40})] == [("front",)]


def test_of_two_halves_that_of_the_reference_is_believed() -> None:
    told = findings({"left": 40, "right": 40, "rear": 40}, {"rear": 50})
    assert [finding.cameras for finding in told] == [("left",), ("right",)]


@pytest.mark.parametrize("late_ms", [0, 10, 20])
def test_stamps_that_still_share_a_bundle_are_no_finding(late_ms: float) -> None:
    assert findings({"left": late_ms}) == []


@pytest.mark.parametrize("every", [{"left": 2}, {"front": 2}, {"left": 3, "rear": 2}])
def test_a_camera_at_a_lower_rate_is_no_finding(every: dict[str, int]) -> None:
    assert findings({}, every) == []


@pytest.mark.parametrize("seed", range(5))
def test_lost_images_are_no_finding_and_hide_none(seed: int) -> None:
    assert findings({}, kept=0.4, seed=seed) == []
    assert [f.cameras for f in findings({"left": 40}, kept=0.7, seed=seed)] == [("left",)]


def test_a_camera_that_runs_freely_has_no_offset_to_tell() -> None:
    watch = StampWatch(RIG, StampWatchConfig())
    free = {int(1e6 * 73 * k): ("left",) for k in range(50)}
    others = {int(1e6 * PERIOD_MS * k) + 1: ("front", "second", "right", "rear") for k in range(36)}
    for stamp_ns, names in sorted((free | others).items()):
        watch.see(FrameBundle(stamp_ns, dict.fromkeys(names, IMAGE)))
    assert list(watch.findings()) == []
