"""What lens, shutter and sensor cost: ``python -m tests.benchmark.sensing_costs`` prints the docs' tables.

CPU time of this process (``time.process_time``), the least of several goes, for bundles of ``first_drive`` at
5 m/s. Stages that render nothing are timed alone; shutters and lenses that render more against a plain
bundle.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import cv2
import mujoco
import numpy as np

from scenarios.load import load_scenario
from sim.light.on_board import OnBoardAtmosphere
from sim.rendering.classic import ClassicRenderer
from sim.rendering.view import Picture, View
from sim.scene import Scene, build_scene
from sim.sensing.atmosphere import ClearAir
from sim.sensing.capture import CameraArray
from sim.sensing.development import Development
from sim.sensing.exposure import AutoExposure
from sim.sensing.face import GreyImage
from sim.sensing.sensor import SensorConfig
from sim.stage import Stage

WORST_OF_STAGES = {"noise": 20.0, "blur": 5.0, "vignetting": 5.0, "dirt": 5.0, "jpeg": 5.0}
STAGES: Mapping[str, Mapping[str, float]] = {
    "noise 1": {"noise": 1},
    **{f"{stage} {at}": {stage: at} for stage in ("blur", "vignetting", "dirt", "jpeg") for at in (1, 3, 5)},
    "all of them at their worst": WORST_OF_STAGES,
}
SHUTTERS: Mapping[str, Mapping[str, float]] = {
    "instant": {},
    "rolling_shutter_s 0.025": {"rolling_shutter_s": 0.025},
    "motion_blur 1": {"motion_blur": 1},
    "motion_blur 3": {"motion_blur": 3},
    "motion_blur 3, rolling_shutter_s 0.025": {"motion_blur": 3, "rolling_shutter_s": 0.025},
}
_GOES, _FROM_S, _APART_S = 3, 1.0, 0.1
_GOES_OF_STAGES = 15


@dataclass(frozen=True)
class Cost:
    """Of a bundle."""

    pictures: float
    ms: float


def main() -> None:
    cv2.setNumThreads(1)
    print("stage that renders nothing: CPU ms a bundle")
    lights = plain_lights()
    with_nothing_ms = developing_ms({}, lights)
    print(f"  {'rounding, metering':<42}{with_nothing_ms:8.1f}")
    for name, settings in STAGES.items():
        print(f"  {name:<42}{developing_ms(settings, lights) - with_nothing_ms:8.1f}", flush=True)
    print("\nshutter: pictures a bundle, CPU ms, times a plain bundle")
    costs = shutter_costs("gap", SHUTTERS)
    costs |= {"instant, rig fisheye": shutter_costs("fisheye", {"instant": {}})["instant"]}
    for name, cost in costs.items():
        ratio = cost.ms / costs["instant"].ms
        print(f"  {name:<42}{cost.pictures:6.0f}{cost.ms:9.0f}{ratio:7.1f}", flush=True)


def developing_ms(settings: Mapping[str, float], lights: Mapping[str, GreyImage]) -> float:
    """Return the CPU ms that it takes to make images of the light of all cameras."""
    config = SensorConfig(**{"noise": 0.0, **settings})
    stages = {name: Development(name, light.shape[::-1], config, 0) for name, light in lights.items()}
    control, air = AutoExposure(), ClearAir()

    def bundle() -> None:
        for name, light in lights.items():
            on_sensor = stages[name].through_lens(light, air, 0.0)
            control.watch(stages[name].on_sensor(on_sensor, control.now, 0))

    return least_ms([bundle] * _GOES_OF_STAGES)


def plain_lights() -> dict[str, GreyImage]:
    """Return the light of one bundle, in whole levels."""
    scene, stage = _staged("gap")
    config = SensorConfig(noise=0.0, exposure="fixed")
    with ClassicRenderer(scene.model) as renderer:
        images = _cameras(scene, stage, config).take(stage, renderer, 0, _FROM_S)
    return {name: image.astype(np.float32) for name, image in images.items()}


def shutter_costs(rig: str, shutters: Mapping[str, Mapping[str, float]]) -> dict[str, Cost]:
    """Return what bundles cost with each shutter, once the exposure has settled."""
    scene, stage = _staged(rig)
    costs = {}
    with CountingRenderer(scene.model) as renderer:
        for name, settings in shutters.items():
            cameras = _cameras(scene, stage, SensorConfig(**{"noise": 0.0, **settings}))
            cameras.take(stage, renderer, 0, _FROM_S)
            renderer.pictures = 0
            times_s = _FROM_S + _APART_S * np.arange(1, _GOES + 1)
            takes = [partial(cameras.take, stage, renderer, 1, float(time_s)) for time_s in times_s]
            ms = least_ms(takes)
            costs[name] = Cost(renderer.pictures / _GOES, ms)
    return costs


class CountingRenderer(ClassicRenderer):
    """Counts the pictures that it renders."""

    pictures = 0

    def render(
        self, data: mujoco.MjData, views: Mapping[str, View], depth: bool = False, keep_shadows: bool = False
    ) -> dict[str, Picture]:
        self.pictures += len(views)
        return super().render(data, views, depth, keep_shadows)


def _staged(rig: str) -> tuple[Scene, Stage]:
    scenario = load_scenario("first_drive", [f"rig={rig}"])
    scene = build_scene(scenario.world, scenario.rig, 0)
    return scene, Stage(scene, scenario.world.drive)


def _cameras(scene: Scene, stage: Stage, config: SensorConfig) -> CameraArray:
    assert scene.atmosphere is not None
    air = OnBoardAtmosphere(scene.atmosphere, scene.model, stage.at)
    return CameraArray(scene.lenses, config, 0, air)


def least_ms(goes: Sequence[Callable[[], object]]) -> float:
    """Return the CPU milliseconds of the quickest."""
    spent_s = []
    for work in goes:
        started_s = time.process_time()
        work()
        spent_s.append(time.process_time() - started_s)
    return 1000 * min(spent_s)


if __name__ == "__main__":
    main()
