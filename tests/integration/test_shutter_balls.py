"""Balls that a car drives past appear where each row saw them: rolling shutter, motion blur, all lenses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.rig_file import read_rig
from estimator.se3 import SE3, Array
from sim.rendering.classic import ClassicRenderer
from sim.scene import assemble_scene
from sim.sensing.capture import CameraArray
from sim.sensing.exposure import Exposure
from sim.sensing.sensor import SensorConfig
from sim.sensing.shutter import Shutter, blur_s
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam
from sim.vehicle.drive import DriveConfig
from sim.vehicle.route import route_along
from tests.ball_world import (
    expected_centroid_px,
    measured_centroid_px,
    outline_px,
    polygon_area,
    rolling_centroid_px,
    write_balls,
)

TOLERANCE_PX = 0.1
SPEED_MPS = 8.0
APART_PX = 36
LEAST_RADIUS_PX = 3.5
TIME_S = 0.5
RIGS = Path(__file__).parents[2] / "scenarios" / "rigs"
CASES = {
    "rolling shutter": (SensorConfig(noise=0, exposure="fixed", rolling_shutter_s=0.03), 15),
    "motion blur": (SensorConfig(noise=0, exposure="fixed", motion_blur=3), 17),
    "both": (SensorConfig(noise=0, exposure="fixed", motion_blur=3, rolling_shutter_s=0.03), 17),
}


@pytest.mark.parametrize(
    ("rig_name", "case"),
    [("gap", "rolling shutter"), ("gap", "motion blur"), ("gap", "both"), ("fisheye", "rolling shutter")],
)
def test_balls_appear_where_their_rows_saw_them(rig_name: str, case: str) -> None:
    config, reach_px = CASES[case]
    rig = read_rig(RIGS / f"{rig_name}.yaml")
    shutter = Shutter(config.rolling_shutter_s, blur_s(Exposure(), config.motion_blur))
    centers, radii_m = _balls_along_the_road()
    line_m = np.column_stack([np.arange(0.0, 30.0, 0.25), np.zeros(120)])
    scene = assemble_scene(lambda spec: write_balls(spec, centers, radii_m), route_along(line_m), rig)
    stage = Stage(scene, DriveConfig(speed_mps=SPEED_MPS, distance_m=10.0))
    cameras = CameraArray(scene.lenses, config, 0)
    errors_px: dict[str, list[float]] = {name: [] for name in rig.cameras}
    moved_px: list[float] = []
    with ClassicRenderer(scene.model) as renderer:
        images = cameras.take(stage, renderer, 0, TIME_S)
    for name, image in images.items():
        camera, pose = rig[name].camera, _poses(stage, name, TIME_S)
        for center, radius_m in _whole_balls(camera, image, pose, centers, radii_m, reach_px):
            expected = rolling_centroid_px(camera, pose, center, radius_m, shutter)
            measured = measured_centroid_px(image, expected, reach_px)
            errors_px[name].append(float(np.linalg.norm(measured - expected)))
            still = expected_centroid_px(camera, pose(0.0).apply(center), radius_m)
            moved_px.append(float(np.linalg.norm(expected - still)))
    for name, errors in errors_px.items():
        print(f"{rig_name} {rig[name].camera.model} {name}: {len(errors)} balls, worst {max(errors):.3f} px")
    print(f"{case}: shift by the shutter up to {max(moved_px):.1f} px")
    everything = np.concatenate(list(errors_px.values()))
    assert len(everything) > 25
    assert np.median(everything) < 0.05
    assert everything.max() < TOLERANCE_PX
    if shutter.readout_s:
        assert max(moved_px) > 4


def _balls_along_the_road() -> tuple[Array, Array]:
    """Balls on both sides at 3 to 6 m, at all heights, and some far ahead and behind."""
    index = np.arange(110)
    side = np.where(index % 2, 1.0, -1.0)
    across_m = side * (3.0 + 3.0 * (index * 0.618 % 1))
    height_m = 0.4 + 2.6 * (index * 0.382 % 1)
    along_m = -12 + 0.42 * index
    return np.column_stack([along_m, across_m, height_m]), 0.022 * (np.abs(across_m) + 0.6)


def _poses(stage: Stage, name: str, middle_s: float) -> Callable[[float], SE3]:
    return lambda offset_s: world_from_cam(stage.at(middle_s + offset_s), name).inverse()


def _whole_balls(
    camera: Camera,
    image: Image,
    pose: Callable[[float], SE3],
    centers: Array,
    radii_m: Array,
    reach_px: int,
) -> list[tuple[Array, float]]:
    """Return the balls that stand alone in the image and are not cut by the car's own body."""
    centers_cam = pose(0.0).apply(centers)
    pixels = camera.project(centers_cam)
    radii_px = max(camera.focal_px) * radii_m / np.linalg.norm(centers_cam, axis=1)
    found = []
    for index in np.flatnonzero(camera.contains(pixels, margin_px=APART_PX) & (radii_px > LEAST_RADIUS_PX)):
        apart_px = np.delete(np.linalg.norm(pixels - pixels[index], axis=1), index)
        column, row = np.rint(pixels[index]).astype(int)
        around = image[row - reach_px : row + reach_px + 1, column - reach_px : column + reach_px + 1]
        outline = outline_px(camera, centers_cam[index], radii_m[index])
        seen = around.sum() / 255 / polygon_area(outline)
        if np.nanmin(apart_px) > APART_PX and 0.9 < seen < 1.1:
            found.append((centers[index], float(radii_m[index])))
    return found
