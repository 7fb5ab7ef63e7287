"""One camera's frames on one drive, at every severity of one effect, with what is needed to check tracks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import TracebackType
from typing import Self

import mujoco

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.se3 import SE3
from scenarios.load import load_scenario
from sim.light.on_board import OnBoardAtmosphere
from sim.rendering.classic import ClassicRenderer
from sim.rendering.view import DepthImage, Picture, Renderer, View
from sim.scene import Scene, build_scene
from sim.sensing.capture import CameraArray
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam
from sim.world import WorldConfig
from tests.benchmark.ladder_effects import Effect

CAMERA, PERIOD_S = "front", 0.1
_TRACKS_BEGIN_EVERY, LONGEST_TRACK = 2, 5  # frames
_PLAIN = ("drive.speed_mps=10", "drive.rate_hz=10", "sensor.noise=0")


@dataclass(frozen=True, eq=False)
class Ride:
    """The frames of a pinhole camera, a metre apart.

    Attributes:
        frames: (H, W) each.
        pinhole: The camera.
        world_from_cams: Its pose at each.
        depths_m: (H, W) of what it sees, by the index of the frame; of those at which tracks begin.
    """

    frames: Sequence[Image]
    pinhole: Camera
    world_from_cams: Sequence[SE3]
    depths_m: Mapping[int, DepthImage]


def rides(effect: Effect, seed: int) -> Iterator[Ride]:
    """Yield one ride a severity; what the effect leaves as it is is built and rendered once."""
    scenarios = [load_scenario("first_drive", [*_PLAIN, *effect.settings_at(v)]) for v in effect.values]
    if effect.is_of_the_sensor:
        scene = build_scene(scenarios[0].world, scenarios[0].rig, seed)
        with ClassicRenderer(scene.model) as classic:
            renderer = classic if effect.is_of_the_shutter else RememberingRenderer(classic)
            for scenario in scenarios:
                yield _ride(scene, scenario.world, renderer, effect, seed)
        return
    for scenario in scenarios:
        scene = build_scene(scenario.world, scenario.rig, seed)
        with ClassicRenderer(scene.model) as classic:
            yield _ride(scene, scenario.world, classic, effect, seed)


def _ride(scene: Scene, world: WorldConfig, renderer: Renderer, effect: Effect, seed: int) -> Ride:
    stage, lens = Stage(scene, world.drive), scene.lenses[CAMERA]
    assert scene.atmosphere is not None
    air = OnBoardAtmosphere(scene.atmosphere, scene.model, stage.at)
    cameras = CameraArray({CAMERA: lens}, world.sensor, seed, air)
    frames, poses, depths_m = [], [], {}
    for index in range(effect.frames):
        time_s = effect.from_s + index * PERIOD_S
        frames.append(cameras.take(stage, renderer, index, time_s)[CAMERA])
        data = stage.at(time_s)
        poses.append(world_from_cam(data, CAMERA))
        if index % _TRACKS_BEGIN_EVERY == 0 and index + LONGEST_TRACK < effect.frames:
            picture = renderer.render(data, lens.views(CAMERA, poses[-1]), depth=True)[CAMERA]
            assert picture.depth_m is not None
            depths_m[index] = picture.depth_m
    return Ride(frames, lens.source, poses, depths_m)


class RememberingRenderer:
    """Another renderer's pictures, each rendered once for as many rides as take it."""

    def __init__(self, renderer: Renderer) -> None:
        self._renderer = renderer
        self._pictures: dict[tuple[bytes, tuple[str, ...], bool], dict[str, Picture]] = {}

    def render(
        self, data: mujoco.MjData, views: Mapping[str, View], depth: bool = False, keep_shadows: bool = False
    ) -> dict[str, Picture]:
        """Return each view's picture; views of one name are alike whenever all else is where it was."""
        key = (data.qpos.tobytes() + data.mocap_pos.tobytes(), tuple(views), depth)
        if key not in self._pictures:
            self._pictures[key] = self._renderer.render(data, views, depth, keep_shadows)
        return self._pictures[key]

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        pass
