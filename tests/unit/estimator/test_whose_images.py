"""Streams of images and mounts, along a known path through a known street."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from estimator.assignment import AssignmentConfig, swapped_cycles
from estimator.epipolar import FitConfig, pairs_of
from estimator.finding import FindingKind
from estimator.keyframe import Keyframe
from estimator.mount_watch import MountWatch, MountWatchConfig
from estimator.rig import Rig
from estimator.se3 import SE3
from estimator.slip import slip_rad
from estimator.whose_images import Fit, fit_streams
from tests.known_scene import known_scene, sightings
from tests.mounts import FISHEYE, PINHOLE, arc, left_side_rig, mounted, shaken

LEFT = left_side_rig(left_rear=FISHEYE)
RIG = Rig(
    "front",
    {
        **LEFT.cameras,
        "right_front": mounted(PINHOLE, (1.2, -0.9, 1.2), -55.0, 12.0),
        "rear": mounted(PINHOLE, (-0.8, 0.0, 1.2), 180.0, 8.0),
    },
    LEFT.prior,
)
NAMES = list(RIG.cameras)


def window(plugged: Mapping[str, str] | None = None, path: tuple[SE3, ...] | None = None) -> list[Keyframe]:
    """Return a window's tracks; ``plugged`` names for a stream the mount that its images truly come from."""
    path = path or arc(1.0, 8)
    scene = known_scene(RIG, path, points_per_view=30)
    seen = sightings(scene, noise_px=0.2)
    plugs = {name: name for name in NAMES} | dict(plugged or {})
    keyframes = []
    for index, pose in enumerate(path):
        tracks = {}
        for stream, mount in plugs.items():
            mine = seen.select((seen.camera == NAMES.index(mount)) & (seen.keyframe == index))
            tracks[stream] = (mine.landmark, mine.pixels)
        keyframes.append(Keyframe(index, {}, pose, tracks))
    return keyframes


def found(watch: MountWatch) -> list[tuple[FindingKind, tuple[str, ...]]]:
    return [(finding.kind, finding.cameras) for finding in watch.findings()]


def watching(keyframes: list[Keyframe], rig: Rig = RIG) -> MountWatch:
    watch = MountWatch(rig, MountWatchConfig())
    watch.see(keyframes)
    return watch


def test_every_stream_fits_its_own_mount_and_no_other() -> None:
    share = fit_streams(window(), shaken(RIG, 3.0, 100.0), FitConfig()).share
    assert share.diagonal().min() > 0.8
    assert (share - np.diag(share.diagonal())).max() < 0.5


def test_a_sound_rig_gives_no_finding() -> None:
    assert found(watching(window(), shaken(RIG, 10.0, 300.0))) == []


@pytest.mark.parametrize(
    "swap", [("left_front", "right_front"), ("left_rear", "rear"), ("left_front", "left_rear")]
)
def test_two_swapped_streams_are_named(swap: tuple[str, str]) -> None:
    a, b = swap
    watch = watching(window({a: b, b: a}), shaken(RIG, 3.0, 100.0))
    assert found(watch) == [(FindingKind.SWAPPED_CAMERAS, swap)]
    assert all(finding.doubtful for finding in watch.findings())


def test_a_cycle_of_three_is_named_whole() -> None:
    cycle = {"left_front": "right_front", "right_front": "rear", "rear": "left_front"}
    (finding,) = watching(window(cycle)).findings()
    assert set(finding.cameras) == set(cycle)


def test_a_swap_is_over_once_windows_show_the_streams_where_they_belong() -> None:
    watch = watching(window({"left_rear": "rear", "rear": "left_rear"}))
    for _ in range(MountWatchConfig().windows):
        watch.see(window())
    assert found(watch) == []


def test_a_reference_swapped_with_another_camera_is_named() -> None:
    swapped = window({"front": "rear", "rear": "front"})
    front_from_rear = RIG["rear"].ego_from_cam @ RIG["front"].ego_from_cam.inverse()
    seeming = [k.world_from_ego @ front_from_rear for k in swapped]
    keyframes = [Keyframe(k.stamp_ns, {}, p, k.tracks) for k, p in zip(swapped, seeming, strict=True)]
    assert found(watching(keyframes)) == [(FindingKind.SWAPPED_CAMERAS, ("front", "rear"))]


def test_a_mount_that_explains_nothing_is_named_alone() -> None:
    pose = RIG["left_rear"].ego_from_cam
    turn = SE3.exp(np.array([0, 0, np.pi / 2, 0, 0, 0]))
    wrong = RIG.with_extrinsics({"left_rear": SE3(turn.rotation @ pose.rotation, pose.translation)})
    assert found(watching(window(), wrong)) == [(FindingKind.UNEXPLAINED_IMAGES, ("left_rear",))]


def test_reversing_is_no_swap() -> None:
    assert found(watching(window(path=arc(-1.0, 8)))) == []


def test_a_car_that_slides_sideways_puts_the_reference_in_doubt() -> None:
    sideways = tuple(SE3(np.eye(3), np.array([0.0, 0.4 * k, 0.0])) for k in range(6))
    keyframes = [Keyframe(k, {}, pose, {}) for k, pose in enumerate(sideways)]
    assert slip_rad(keyframes) == pytest.approx(np.pi / 2)
    assert found(watching(keyframes)) == [(FindingKind.NOMINAL_REJECTED, ("front",))]


def test_streams_without_tracks_say_nothing() -> None:
    empty = [Keyframe(k, {}, pose, {}) for k, pose in enumerate(arc(1.0, 6))]
    assert len(pairs_of(empty, "front")) == 0
    assert found(watching(empty)) == []


def test_images_of_another_size_are_not_tried_on_a_mount() -> None:
    small = mounted(PINHOLE, (1.0, 0.0, 1.0), 0.0, 0.0)
    camera = type(PINHOLE)("pinhole", (100, 100), (80.0, 80.0), (49.5, 49.5))
    rig = Rig("front", {**RIG.cameras, "rear": type(small)(camera, RIG["rear"].ego_from_cam)}, RIG.prior)
    fit = fit_streams(window(), rig, FitConfig())
    assert fit.total[NAMES.index("left_rear"), NAMES.index("rear")] == 0


def test_a_stream_stays_where_two_mounts_fit_alike() -> None:
    share = np.array([[0.95, 0.97], [0.97, 0.95]])
    assert swapped_cycles(Fit(100 * share, np.full((2, 2), 100.0)), AssignmentConfig()) == []
