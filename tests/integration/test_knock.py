"""A knock in pictures: nothing of it before its time; afterwards the balls are where the moved truth says."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.se3 import Array
from sim.rendering.classic import ClassicRenderer
from sim.scene import assemble_scene
from sim.sensing.capture import CameraArray
from sim.sensing.sensor import SensorConfig
from sim.simulate import read_truth
from sim.stage import Stage
from sim.vehicle.drive import DriveConfig
from sim.vehicle.miscalibration import MiscalibrationConfig, miscalibrate, moving_mounts
from sim.world import Truth
from tests.ball_world import expected_centroid_px, measured_centroid_px, write_balls
from tests.drives import STRAIGHT
from tests.mounts import left_side_rig

RIG = left_side_rig(Camera("pinhole", (320, 200), (180.0, 180.0), (159.5, 99.5)))
DRIVE = DriveConfig(distance_m=3.0, rate_hz=5.0)
KNOCK = {"at_s": 0.3, "camera": "left_rear", "kind": "knock", "rotation_deg": 2.0, "translation_mm": 40}


def balls() -> tuple[Array, Array]:
    turn = np.linspace(0.0, 2 * np.pi, 24, endpoint=False)
    return np.column_stack([8 * np.cos(turn), 8 * np.sin(turn), np.full(24, 1.3)]), np.full(24, 0.15)


@dataclass(frozen=True, eq=False)
class Shot:
    truth: Truth
    images: dict[str, Image]


def shoot(events: list[dict[str, object]]) -> list[Shot]:
    """Drive three metres among balls and take four bundles."""
    config = MiscalibrationConfig.model_validate({"events": events})
    true_rig = RIG.with_extrinsics(miscalibrate(RIG, config, 2))
    scene = assemble_scene(
        lambda spec: write_balls(spec, *balls()), STRAIGHT, true_rig, mounts=moving_mounts(RIG, config, 2)
    )
    stage = Stage(scene, DRIVE)
    cameras = CameraArray(scene.lenses, SensorConfig(exposure="fixed"), 2)
    shots = []
    with ClassicRenderer(scene.model) as renderer:
        for index in range(DRIVE.bundle_count):
            images = cameras.take(stage, renderer, index, DRIVE.time_s(index))
            shots.append(Shot(read_truth(scene, stage, DRIVE.time_s(index)), images))
    return shots


@pytest.fixture(scope="module")
def knocked() -> list[Shot]:
    return shoot([KNOCK])


def test_until_the_knock_every_byte_is_as_without_it_and_then_only_its_camera_differs(
    knocked: list[Shot],
) -> None:
    for index, (with_knock, without) in enumerate(zip(knocked, shoot([]), strict=True)):
        for name in RIG.cameras:
            same = with_knock.images[name].tobytes() == without.images[name].tobytes()
            assert same == (index < 2 or name != "left_rear")
            poses = with_knock.truth.ego_from_cams[name], without.truth.ego_from_cams[name]
            # The pose comes back out of the world's, so only to rounding.
            assert (np.abs(poses[0].local(poses[1])).max() < 1e-9) == same


def test_the_pictures_after_the_knock_agree_with_the_truth_after_it(knocked: list[Shot]) -> None:
    centers, radii_m = balls()
    errors_px = []
    for shot in knocked[2:]:
        camera, image = RIG["left_rear"].camera, shot.images["left_rear"]
        world_from_cam = shot.truth.world_from_ego @ shot.truth.ego_from_cams["left_rear"]
        centers_cam = world_from_cam.inverse().apply(centers)
        pixels = camera.project(centers_cam)
        for index in np.flatnonzero(camera.contains(pixels, margin_px=14)):
            expected = expected_centroid_px(camera, centers_cam[index], radii_m[index])
            if image[tuple(np.rint(expected).astype(int)[::-1])] > 200:
                measured = measured_centroid_px(image, expected, 9)
                errors_px.append(np.linalg.norm(measured - expected))
    assert len(errors_px) >= 4
    assert np.median(errors_px) < 0.1
