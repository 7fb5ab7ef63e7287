"""The short cuts of the renderer (shadows drawn once, nothing drawn that is out of view) change no pixel."""

from __future__ import annotations

from collections.abc import Iterator

import mujoco
import numpy as np
import pytest

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.rendering.classic import SUN_DISTANCE_M, ClassicRenderer
from sim.rendering.quality import write_visual_settings
from sim.rendering.shadow_map import soften
from sim.rendering.view import View
from sim.vehicle.cameras import write_cameras
from sim.vehicle.car_physics import physics_spec

SOURCE = Camera("pinhole", (240, 160), (150.0, 150.0), (119.5, 79.5))
TOWARD = np.array([0.4, 0.3, -0.87]) / np.linalg.norm([0.4, 0.3, -0.87])


def looking(yaw_deg: float) -> SE3:
    """A camera 1.5 m up, looking along a yaw."""
    yaw = np.radians(yaw_deg)
    forward = np.array([np.cos(yaw), np.sin(yaw), 0.0])
    right = np.array([np.sin(yaw), -np.cos(yaw), 0.0])
    return SE3(np.column_stack([right, [0.0, 0.0, -1.0], forward]), np.array([0.0, 0.0, 1.5]))


SOURCES = {"ahead": SOURCE, "left": SOURCE, "behind": SOURCE}
POSES = {"ahead": looking(0), "left": looking(80), "behind": looking(180)}


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    spec = physics_spec()
    rng = np.random.default_rng(0)
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[60, 60, 1], rgba=[0.6, 0.6, 0.6, 1])
    for position in rng.uniform(-25, 25, (80, 2)):
        size = rng.uniform(0.3, 2.0, 3)
        spec.worldbody.add_geom(
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=size,
            pos=[*position, size[2]],
            rgba=[*rng.uniform(0.2, 1, 3), 1],
        )
    sun = spec.worldbody.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL, castshadow=True, diffuse=[1, 1, 1]
    )
    sun.pos, sun.dir = -SUN_DISTANCE_M * TOWARD, TOWARD
    write_cameras(spec.worldbody, SOURCES, POSES)
    write_visual_settings(spec, SOURCE.size_px)
    return spec.compile()


@pytest.fixture(scope="module")
def pictures(model: mujoco.MjModel) -> Iterator[dict[str, np.ndarray]]:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    views = {name: View(SOURCE, pose) for name, pose in POSES.items()}
    with ClassicRenderer(model) as renderer:
        renderer.render(data, views)  # the second time must not depend on the first
        yield {name: picture.rgb for name, picture in renderer.render(data, views).items()}


@pytest.mark.parametrize("name", SOURCES)
def test_pictures_are_mujocos_own(model: mujoco.MjModel, pictures: dict[str, np.ndarray], name: str) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, SOURCE.size_px[1], SOURCE.size_px[0]) as reference:
        soften(reference._mjr_context)  # the one thing that is not MuJoCo's own
        reference.update_scene(data, name)
        apart = np.abs(pictures[name].astype(int) - reference.render())
    assert (
        apart > 0
    ).mean() < 0.002  # the light's position is rounded, and with it the edges of soft shadows
    assert apart.max() < 16


def test_things_cast_shadows(model: mujoco.MjModel, pictures: dict[str, np.ndarray]) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, SOURCE.size_px[1], SOURCE.size_px[0]) as reference:
        reference.update_scene(data, "left")
        reference.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = False
        darker = reference.render().astype(int) - pictures["left"]
    assert (darker > 20).mean() > 0.005


def test_edges_of_shadows_are_no_stairs() -> None:
    """Seen from so near that a texel of the shadow map covers many pixels, light must fade across it."""
    spec = physics_spec()
    spec.visual.headlight.diffuse = spec.visual.headlight.specular = [0, 0, 0]
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[20, 20, 1], pos=[0, 0, -1])
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[5, 5, 0.1], pos=[-5, 0, 3])
    spec.worldbody.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        castshadow=True,
        diffuse=[0.8, 0.8, 0.8],
        dir=[0.0, 0.1, -1.0],
    )
    write_visual_settings(spec, SOURCE.size_px)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    down = SE3(np.array([[1.0, 0, 0], [0, -1, 0], [0, 0, -1]]), np.array([0.0, 0.0, 0.4]))
    with ClassicRenderer(model) as renderer:
        row = renderer.render(data, {"eye": View(SOURCE, down)})["eye"].rgb[80, :, 1].astype(int)
    assert np.ptp(row) > 50
    assert len(np.unique(row)) > 6 and np.abs(np.diff(row)).max() < np.ptp(row) / 3
