"""Cameras put together: what is off leaves no trace, and each effect keeps to itself."""

from __future__ import annotations

from collections.abc import Mapping

import mujoco
import numpy as np
import pytest

from estimator.bundle import Image
from estimator.camera import Camera
from sim.rendering.view import Picture, View
from sim.seeds import rng_for
from sim.sensing.atmosphere import grey
from sim.sensing.capture import CameraArray
from sim.sensing.defocus import defocus, disc_kernel
from sim.sensing.dirt import splash
from sim.sensing.face import GreyImage
from sim.sensing.jpeg import through_jpeg
from sim.sensing.lens import make_lens
from sim.sensing.sensor import SensorConfig, expose
from sim.sensing.vignetting import transmission
from sim.vehicle.cameras import world_from_cam

CAMERA = Camera("pinhole", (96, 64), (80.0, 80.0), (47.5, 31.5))
XML = """<mujoco><worldbody><body pos="0 0 1"><freejoint/><geom size="0.1" pos="0 0 -9"/>
  <camera name="eye" xyaxes="0 -1 0 0 0 1"/><camera name="other" xyaxes="0 -1 0 0 0 1"/></body>
  </worldbody></mujoco>"""
SEED = 5
EFFECTS = ("blur", "vignetting", "dirt", "jpeg", "noise")


class DrivingStage:
    """A car that drives straight ahead at 20 m/s."""

    def __init__(self) -> None:
        self._model = mujoco.MjModel.from_xml_string(XML)
        self._data = mujoco.MjData(self._model)

    def at(self, time_s: float) -> mujoco.MjData:
        self._data.qpos[0] = 20 * time_s
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)
        return self._data


class PaintedWall:
    """Renders a textured wall 8 m ahead of where the drive begins, by intersecting every pixel's ray."""

    def render(
        self, data: mujoco.MjData, views: Mapping[str, View], depth: bool = False, keep_shadows: bool = False
    ) -> dict[str, Picture]:
        return {name: self._picture(view) for name, view in views.items()}

    def _picture(self, view: View) -> Picture:
        width, height = view.pinhole.size_px
        columns, rows = np.meshgrid(np.arange(float(width)), np.arange(float(height)))
        rays_cam = view.pinhole.unproject(np.column_stack([columns.ravel(), rows.ravel()]))
        rays = rays_cam @ view.world_from_cam.rotation.T
        reach_m = (8 - view.world_from_cam.translation[0]) / rays[:, 0]
        points = view.world_from_cam.translation + rays * reach_m[:, None]
        level = 105 + 40 * np.sin(4 * points[:, 1]) * np.cos(3 * points[:, 2]) + 20 * np.sin(9 * points[:, 2])
        rgb = np.repeat(np.rint(level).astype(np.uint8).reshape(height, width, 1), 3, axis=2)
        return Picture(rgb, (rays_cam[:, 2] * reach_m).reshape(height, width).astype(np.float32))


def take(config: SensorConfig, cameras: tuple[str, ...] = ("eye",), count: int = 1) -> list[Image]:
    array = CameraArray(dict.fromkeys(cameras, make_lens(CAMERA)), config, SEED)
    stage, renderer = DrivingStage(), PaintedWall()
    return [
        array.take(stage, renderer, index, 0.1 * index)["eye"]  # type: ignore[arg-type]
        for index in range(count)
    ]


def plain_light() -> GreyImage:
    stage = DrivingStage()
    lens = make_lens(CAMERA)
    views = lens.views("eye", world_from_cam(stage.at(0.0), "eye"))
    return grey(PaintedWall().render(stage.at(0.0), views)["eye"].rgb)


def noise_rng() -> np.random.Generator:
    return rng_for(SEED, "sensor.eye.0")


def test_with_everything_off_the_image_is_the_rounded_picture() -> None:
    assert np.array_equal(take(SensorConfig(noise=0))[0], expose(plain_light(), 0.0, noise_rng()))


@pytest.mark.parametrize("effect", EFFECTS)
def test_severity_zero_leaves_the_bytes_as_without(effect: str) -> None:
    others = {name: 2.0 for name in EFFECTS if name != effect}
    image = take(SensorConfig(**others | {effect: 0.0}))[0]
    light = plain_light()
    if effect != "blur":
        light = defocus(light, disc_kernel(2.0))
    if effect != "dirt":
        light = splash(CAMERA.size_px, 2.0, rng_for(SEED, "sensor.dirt.eye")).over(light)
    if effect != "vignetting":
        light = light * transmission(CAMERA.size_px, 2.0, rng_for(SEED, "sensor.vignetting.eye"))
    expected = expose(light, others.get("noise", 0.0), noise_rng())
    assert np.array_equal(image, expected if effect == "jpeg" else through_jpeg(expected, 2.0))


def test_a_day_is_exposed_automatically_as_it_is_fixed() -> None:
    automatic, fixed = (take(SensorConfig(exposure=mode), count=3) for mode in ("auto", "fixed"))
    assert all(np.array_equal(one, other) for one, other in zip(automatic, fixed, strict=True))


def test_other_cameras_do_not_matter() -> None:
    config = SensorConfig(dirt=2, vignetting=2)
    assert np.array_equal(take(config)[0], take(config, ("other", "eye"))[0])


@pytest.mark.parametrize("config", [{"motion_blur": 5}, {"rolling_shutter_s": 0.03}])
def test_the_shutter_changes_only_what_moves(config: dict[str, float]) -> None:
    """Driving at the wall blurs and bends its rim, and leaves the point it drives at alone."""
    still, taken = (take(SensorConfig(noise=0, **each))[0].astype(float) for each in ({}, config))
    change = np.abs(taken - still)
    assert change[28:36, 44:52].max() <= 1.5
    assert change.max() > 2


def test_the_same_seed_gives_the_same_bytes_under_any_shutter() -> None:
    config = SensorConfig(motion_blur=3, rolling_shutter_s=0.02, dirt=1)
    first, second = take(config, count=2), take(config, count=2)
    assert [image.tobytes() for image in first] == [image.tobytes() for image in second]
