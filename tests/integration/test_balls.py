"""Small bright balls must appear where ``Camera.project`` says, for every camera model and the whole image.

A convention error shared by world and estimator could not survive this: the pose comes from MuJoCo's own
``cam_xpos`` and ``cam_xmat``, the picture from the renderer, the pixel from the vocabulary.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.rig_file import read_rig
from estimator.se3 import SE3, Array
from sim.rendering.classic import ClassicRenderer
from sim.rendering.quality import write_visual_settings
from sim.scene import assemble_scene
from sim.sensing.atmosphere import grey
from sim.sensing.capture import CameraArray
from sim.sensing.lens import make_lens
from sim.sensing.sensor import SensorConfig, expose
from sim.simulate import read_truth
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam, write_cameras
from sim.vehicle.car_physics import physics_spec
from sim.vehicle.drive import DriveConfig
from sim.vehicle.miscalibration import MiscalibrationConfig, miscalibrate
from sim.vehicle.route import route_along
from tests.ball_world import (
    balls_in_view,
    expected_centroid_px,
    measured_centroid_px,
    write_balls,
)

TOLERANCE_PX = 0.1  # of one ball; four samples a pixel alone cost half of it
SYSTEMATIC_TOLERANCE_PX = 0.02  # of all balls together: a pixel convention off by a half would show
MARGIN_PX = 12
RADIUS_PX = 6.0
REACH_PX = 11
RIG = read_rig(Path(__file__).parents[2] / "scenarios" / "rigs" / "gap.yaml")
FISHEYE_RIG = read_rig(Path(__file__).parents[2] / "scenarios" / "rigs" / "fisheye.yaml")
DARK = SensorConfig(noise=0, exposure="fixed")  # a camera would open up for a dark world until balls glare
CAMERAS = {
    "pinhole": RIG["front"].camera,
    "pinhole off centre, pixels not square": Camera("pinhole", (640, 400), (400.0, 380.0), (290.3, 221.7)),
    "pinhole of odd size": Camera("pinhole", (533, 401), (300.0, 300.0), (270.2, 190.9)),
    "brown_conrady": RIG["left_front"].camera,
    "kannala_brandt": RIG["rear"].camera,
    "fisheye": FISHEYE_RIG["left_front"].camera,
}


@pytest.mark.parametrize("camera", CAMERAS.values(), ids=CAMERAS.keys())
def test_balls_appear_where_the_camera_projects_them(camera: Camera) -> None:
    body_from_cam = SE3.exp(np.array([0.3, -1.2, 0.7, 0.4, -0.2, 1.5]))
    body_pose = SE3.exp(np.array([0.1, 0.2, -2.0, 5.0, -3.0, 1.0]))
    centers, radii_m = balls_in_view(camera, body_pose @ body_from_cam, RADIUS_PX, MARGIN_PX)
    lens = make_lens(camera)
    spec = physics_spec()
    write_balls(spec, centers, radii_m)
    body = spec.worldbody.add_body(pos=body_pose.translation, quat=body_pose.quaternion_xyzw[[3, 0, 1, 2]])
    write_cameras(body, {"eye": lens.source}, {"eye": body_from_cam})
    write_visual_settings(spec, lens.largest_px)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with ClassicRenderer(model) as renderer:
        pictures = renderer.render(data, lens.views("eye", world_from_cam(data, "eye")))
    light = lens.apply([grey(pictures[key].rgb) for key in lens.keys("eye")])
    image = expose(light, 0.0, np.random.default_rng(0))
    centers_cam = world_from_cam(data, "eye").inverse().apply(centers)
    expected = [
        expected_centroid_px(camera, center, radius)
        for center, radius in zip(centers_cam, radii_m, strict=True)
    ]
    errors_px = np.array([measured_centroid_px(image, pixel, REACH_PX) - pixel for pixel in expected])
    assert image.shape == camera.size_px[::-1]
    worst_px = np.linalg.norm(errors_px, axis=1).max()
    print(f"{camera.model} {camera.size_px}: {len(errors_px)} balls, worst {worst_px:.3f} px")
    assert worst_px < TOLERANCE_PX
    assert np.abs(errors_px.mean(0)).max() < SYSTEMATIC_TOLERANCE_PX


def test_truth_of_a_moving_car_explains_its_pictures() -> None:
    """Drive into a bend among balls with miscalibrated cameras: truth must say where each ball is."""
    true_rig = RIG.with_extrinsics(miscalibrate(RIG, MiscalibrationConfig(), 3))
    centers, radii_m = _balls_around_the_bend()
    arc = np.arange(0.0, 40.0, 0.25)
    line_m = 12 * np.column_stack([np.sin(arc / 12), 1 - np.cos(arc / 12)])
    scene = assemble_scene(lambda spec: write_balls(spec, centers, radii_m), route_along(line_m), true_rig)
    config = DriveConfig(distance_m=4.0, rate_hz=2.0)
    stage, cameras = Stage(scene, config), CameraArray(scene.lenses, DARK, 0)
    errors_px = []
    with ClassicRenderer(scene.model) as renderer:
        for index in range(config.bundle_count):
            images = cameras.take(stage, renderer, index, config.time_s(index))
            truth = read_truth(scene, stage, config.time_s(index))
            for name, image in images.items():
                world_from_cam_true = truth.world_from_ego @ truth.ego_from_cams[name]
                errors_px += _errors_px(RIG[name].camera, image, world_from_cam_true, centers, radii_m)
    assert len(errors_px) > 50
    assert np.median(errors_px) < 0.05
    assert np.quantile(errors_px, 0.95) < TOLERANCE_PX  # the car's own body cuts a few


def _balls_around_the_bend() -> tuple[Array, Array]:
    turn = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    height_m = 1.4 + 0.6 * np.sin(5 * turn)
    return np.column_stack([9 * np.cos(turn), 9 * np.sin(turn) + 1, height_m]), np.full(48, 0.12)


def _errors_px(camera: Camera, image: Image, pose: SE3, centers: Array, radii_m: Array) -> list[float]:
    """Return the error of every ball that stands alone and whole in the image."""
    centers_cam = pose.inverse().apply(centers)
    pixels = camera.project(centers_cam)
    whole = camera.contains(pixels, margin_px=3 * REACH_PX)
    errors = []
    for index in np.flatnonzero(whole):
        apart_px = np.delete(np.linalg.norm(pixels - pixels[index], axis=1), index)
        if (
            np.nanmin(apart_px) > 3 * REACH_PX
            and image[tuple(np.rint(pixels[index]).astype(int)[::-1])] > 200
        ):
            expected = expected_centroid_px(camera, centers_cam[index], radii_m[index])
            errors.append(float(np.linalg.norm(measured_centroid_px(image, expected, REACH_PX) - expected)))
    return errors
