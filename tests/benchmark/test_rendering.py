"""How long the renderers take, as a ratio to a bare loop over ``mujoco.Renderer`` on the same compiled model.

CPU seconds of this process, for wall time depends on who else works on the machine. Without lens and sensor.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import get_args

import mujoco
import pytest

from estimator.camera import Camera
from scenarios.load import load_scenario
from scenarios.scenario import Scenario
from sim.rendering.choice import RENDERER_NAMES, open_renderer, probe
from sim.rendering.names import Quality, RendererName
from sim.rendering.view import View
from sim.scene import Scene, build_scene
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam

MOST_TIMES_BARE = 1.15
BUNDLES = 4
SPACING_S = 0.5
EYE = Camera("pinhole", (640, 400), (457.0, 457.0), (319.5, 199.5))


@pytest.fixture(scope="module")
def scenario() -> Scenario:
    return load_scenario("first_drive")


@pytest.fixture(scope="module", params=get_args(Quality))
def scene(request: pytest.FixtureRequest, scenario: Scenario) -> tuple[Quality, Scene]:
    world = scenario.world.model_copy(update={"quality": request.param})
    return request.param, build_scene(world, scenario.rig, 0)


@pytest.fixture(scope="module")
def bare_s(scene: tuple[Quality, Scene], scenario: Scenario) -> float:
    """CPU seconds a bundle of seven 640 x 400 images of MuJoCo's own renderer in a plain loop."""
    model = scene[1].model
    with mujoco.Renderer(model, 400, 640, max_geom=20_000) as renderer:

        def draw(data: mujoco.MjData) -> None:
            for name in scenario.rig.cameras:
                renderer.update_scene(data, name)
                renderer.render()

        return _seconds_a_bundle(scene[1], scenario, draw)


@pytest.mark.parametrize("name", RENDERER_NAMES)
def test_seven_images_a_bundle(
    scene: tuple[Quality, Scene], bare_s: float, scenario: Scenario, name: RendererName
) -> None:
    quality, world = scene
    if probe(name).problem is not None:
        pytest.skip(f"{name}: {probe(name).problem}")
    with open_renderer(name, world.model) as renderer:

        def draw(data: mujoco.MjData) -> None:
            renderer.render(
                data, {camera: View(EYE, world_from_cam(data, camera)) for camera in scenario.rig.cameras}
            )

        ours_s = _seconds_a_bundle(world, scenario, draw)
    times_bare = ours_s / bare_s
    print(
        f"\n{name:<10}{quality:<10}{ours_s:7.2f} CPU s a bundle, {1 / ours_s:5.2f} bundles a CPU second, "
        f"{times_bare:5.2f} times the bare loop's {bare_s:.2f}"
    )
    if name == "classic" or (name == "pyrender" and quality != "draft"):
        assert times_bare < MOST_TIMES_BARE


def _seconds_a_bundle(scene: Scene, scenario: Scenario, draw: Callable[[mujoco.MjData], None]) -> float:
    stage = Stage(scene, scenario.world.drive)
    draw(stage.at(0.0))  # shaders and buffers are made on first use
    instants = [index * SPACING_S for index in range(1, BUNDLES + 1)]
    spent_s = 0.0
    for instant_s in instants:
        data = stage.at(instant_s)
        started_s = time.process_time()
        draw(data)
        spent_s += time.process_time() - started_s
    return spent_s / BUNDLES
