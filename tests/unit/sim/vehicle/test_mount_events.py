"""Knock, creep, heat and vibration: each exactly as large as stated, at its time, to its cameras alone."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np
import pytest
from pydantic import ValidationError

from estimator.camera import Camera
from estimator.errors import InputError
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3
from sim.scene import assemble_scene
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam
from sim.vehicle.car_state import world_from_ego
from sim.vehicle.drive import DriveConfig
from sim.vehicle.miscalibration import MiscalibrationConfig, Mounts, miscalibrate, moving_mounts
from tests.drives import STRAIGHT

CAMERA = Camera("pinhole", (640, 400), (457.0, 457.0), (319.5, 199.5))
POSE = SE3.exp(np.array([0.1, 0.5, -1.0, 1.0, 0.2, 1.4]))
RIG = Rig("front", {name: MountedCamera(CAMERA, POSE) for name in ("front", "left", "right", "rear")})


def with_events(*events: dict[str, Any]) -> MiscalibrationConfig:
    return MiscalibrationConfig.model_validate({"events": list(events)})


def mounts_of(*events: dict[str, Any], seed: int = 4) -> Mounts:
    return moving_mounts(RIG, with_events(*events), seed)


def sizes(mounts: Mounts, camera: str, time_s: float) -> tuple[float, float]:
    """Angle in degrees and length in mm by which a camera is off its starting pose."""
    start = mounts.starting[camera]
    now = mounts.moved(camera, time_s) or start
    shift_m = np.linalg.norm(now.translation - start.translation)
    return float(np.degrees((start.inverse() @ now).angle_rad)), 1000 * float(shift_m)


KNOCK = {"at_s": 4.0, "camera": "rear", "kind": "knock", "rotation_deg": 0.5, "translation_mm": 12.0}


@pytest.mark.parametrize("seed", range(5))
def test_a_knock_is_at_once_and_exactly_the_stated_angle_and_length(seed: int) -> None:
    mounts = mounts_of(KNOCK, seed=seed)
    assert mounts.moved("rear", 3.9999) is None
    assert sizes(mounts, "rear", 4.0) == pytest.approx((0.5, 12.0), abs=1e-9)
    assert sizes(mounts, "rear", 400.0) == pytest.approx((0.5, 12.0), abs=1e-9)
    assert list(mounts.movements) == ["rear"]


def test_a_creep_grows_evenly_and_stays() -> None:
    mounts = mounts_of({**KNOCK, "kind": "creep", "duration_s": 10.0})
    for time_s, share in ((4.0, 0.0), (6.5, 0.25), (9.0, 0.5), (14.0, 1.0), (50.0, 1.0)):
        assert sizes(mounts, "rear", time_s) == pytest.approx((0.5 * share, 12.0 * share), abs=1e-9)


def test_heat_moves_a_camera_to_and_fro_and_brings_it_back() -> None:
    mounts = mounts_of({**KNOCK, "kind": "thermal", "period_s": 20.0})
    assert sizes(mounts, "rear", 9.0) == pytest.approx((0.5, 12.0), abs=1e-9)
    assert sizes(mounts, "rear", 14.0) == pytest.approx((0.0, 0.0), abs=1e-9)
    there, back = mounts.moved("rear", 9.0), mounts.moved("rear", 19.0)
    assert there is not None and back is not None
    middle = (there.translation + back.translation) / 2
    np.testing.assert_allclose(middle, mounts.starting["rear"].translation, atol=1e-12)


def test_a_vibration_never_exceeds_its_size_nearly_reaches_it_and_ends() -> None:
    mounts = mounts_of({**KNOCK, "kind": "vibration", "frequency_hz": 20.0, "duration_s": 6.0})
    angles = [sizes(mounts, "rear", time_s)[0] for time_s in np.arange(4.0, 10.0, 0.003)]
    assert 0.45 < max(angles) <= 0.5
    assert mounts.moved("rear", 10.0) is None
    # Pictures at ten a second must see it, though the rate divides the frequency.
    assert np.std([sizes(mounts, "rear", time_s)[0] for time_s in np.arange(4.0, 10.0, 0.1)]) > 0.05


def test_a_vibration_has_its_frequency() -> None:
    mounts = mounts_of({**KNOCK, "kind": "vibration", "frequency_hz": 20.0})
    (movement,) = mounts.movements["rear"]
    times_s = np.arange(4.0, 14.0, 0.005)
    spectrum = np.abs(np.fft.rfft([movement.event.share(t, movement.phases) for t in times_s]))
    assert np.fft.rfftfreq(len(times_s), 0.005)[spectrum.argmax()] == pytest.approx(20.0, abs=0.2)


def test_all_means_every_camera_but_the_reference_and_each_goes_its_own_way() -> None:
    mounts = mounts_of({**KNOCK, "camera": "all"})
    assert set(mounts.movements) == {"left", "right", "rear"}
    shifts = [mounts.movements[name][0].shift_m for name in mounts.movements]
    assert not np.allclose(shifts[0], shifts[1]) and not np.allclose(shifts[1], shifts[2])


def test_events_add_up_and_leave_each_others_directions_alone() -> None:
    later = {**KNOCK, "at_s": 6.0, "translation_mm": 7.0}
    one, both = mounts_of(KNOCK), mounts_of(KNOCK, later)
    alone, first = one.moved("rear", 5.0), both.moved("rear", 5.0)
    assert alone is not None and first is not None
    np.testing.assert_array_equal(alone.matrix, first.matrix)
    second = both.moved("rear", 7.0)
    assert second is not None
    assert np.linalg.norm(second.translation - first.translation) == pytest.approx(0.007)
    assert np.degrees((first.inverse() @ second).angle_rad) == pytest.approx(0.5)


def test_a_later_time_or_another_size_keeps_the_direction() -> None:
    shift = mounts_of(KNOCK).movements["rear"][0].shift_m
    changed = mounts_of({**KNOCK, "at_s": 5.0, "translation_mm": 24.0}).movements["rear"][0].shift_m
    np.testing.assert_allclose(changed, 2 * shift)


def test_events_leave_the_starting_error_as_it_was() -> None:
    with_knock, without = (
        miscalibrate(RIG, config, 4) for config in (with_events(KNOCK), MiscalibrationConfig())
    )
    for name in RIG.cameras:
        np.testing.assert_array_equal(with_knock[name].matrix, without[name].matrix)


@pytest.mark.parametrize(
    ("camera", "message"),
    [
        ("front", "miscalibration.events[0].camera: got 'front', the reference camera, whose pose is known"),
        (["rear", "rera"], "got 'rera', wanted a camera of the rig; there are: left, right, rear, or all"),
    ],
)
def test_a_camera_that_cannot_be_moved_is_refused(camera: object, message: str) -> None:
    with pytest.raises(InputError) as error:
        mounts_of({**KNOCK, "camera": camera})
    assert message in str(error.value)


@pytest.mark.parametrize(
    "wrong",
    [
        {"kind": "creep"},  # no duration_s
        {"kind": "thermal", "period_s": 0.5},
        {"kind": "vibration", "frequency_hz": 500.0},
        {"kind": "knock", "duration_s": 1.0},
        {"kind": "bump"},
        {"at_s": -1.0},
        {"rotation_deg": 31.0},
        {"camera": []},
    ],
)
def test_an_event_that_makes_no_sense_is_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(ValidationError):
        with_events({**KNOCK, **wrong})


def stage_with(mounts: Mounts) -> Stage:
    true_rig = RIG.with_extrinsics(miscalibrate(RIG, MiscalibrationConfig(), 4))
    scene = assemble_scene(lambda spec: None, STRAIGHT, true_rig, mounts=mounts)
    return Stage(scene, DriveConfig(distance_m=20.0))


def test_the_stage_shows_each_camera_where_it_is_at_any_time_in_any_order() -> None:
    mounts = mounts_of({**KNOCK, "at_s": 2.0})
    stage, steady = stage_with(mounts), stage_with(mounts_of())
    for time_s in (1.9, 2.1, 1.95, 2.0, 1.99):
        moving, still = stage.at(time_s), steady.at(time_s)
        for name in RIG.cameras:
            knocked = name == "rear" and time_s >= 2.0
            same = np.array_equal(moving.cam(name).xmat, still.cam(name).xmat)
            assert same != knocked
        expected = mounts.moved("rear", time_s) or mounts.starting["rear"]
        seen = world_from_ego(moving).inverse() @ world_from_cam(moving, "rear")
        assert np.abs(seen.local(expected)).max() < 1e-9


def test_a_scene_can_be_staged_again_after_a_knock() -> None:
    true_rig = RIG.with_extrinsics(miscalibrate(RIG, MiscalibrationConfig(), 4))
    scene = assemble_scene(lambda spec: None, STRAIGHT, true_rig, mounts=mounts_of({**KNOCK, "at_s": 1.0}))
    first = Stage(scene, DriveConfig(distance_m=20.0))
    start = world_from_cam(first.at(0.0), "rear").matrix
    first.at(1.5)
    again = Stage(scene, DriveConfig(distance_m=20.0))
    np.testing.assert_array_equal(world_from_cam(again.at(0.0), "rear").matrix, start)
    assert isinstance(again.at(1.5), mujoco.MjData)
