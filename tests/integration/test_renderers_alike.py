"""The same scenario looks alike in all renderers: through weather, traffic, fisheyes and rolling shutters."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import cv2
import numpy as np
import pytest

import sim.scene
from estimator.bundle import Image
from scenarios.load import load_scenario
from sim.light.on_board import OnBoardAtmosphere
from sim.rendering.choice import open_renderer
from sim.rendering.names import RendererName
from sim.sensing.capture import CameraArray
from sim.stage import Stage

INSTANT_S = 1.5
STREET = (
    "rig=fisheye",
    "quality=draft",
    "street.kind=straight",
    "street.length_m=40",
    "drive.distance_m=10",
    "street.traffic={cars: 3, cyclists: 3, pedestrians: 3}",
)
CONDITIONS: dict[str, tuple[str, tuple[str, ...]]] = {  # which camera looks, and what is special
    "noon": ("front", ()),
    "fog": ("front", ("weather.fog=3",)),
    "rain": ("front", ("weather.rain=4", "weather.wet_lens=3")),
    "night": ("front", ("weather.night=4",)),
    "rolling_fisheye": ("rear", ("sensor.rolling_shutter_s=0.01",)),
}
PAIRS = [
    ("noon", "filament"),
    ("noon", "pyrender"),
    ("fog", "filament"),
    ("rain", "pyrender"),
    ("night", "pyrender"),  # by Filament it is refused
    ("rolling_fisheye", "filament"),
    ("rolling_fisheye", "pyrender"),
]


@pytest.fixture(scope="module", autouse=True)
def street_built_once() -> Iterator[None]:
    """Build the street once: it does not depend on the weather."""
    build: Callable[..., Any] = sim.scene.build_street
    built: list[Any] = []

    def build_once(config: Any, rng: np.random.Generator) -> Any:
        if not built:
            built.append(build(config, rng))
        return built[0]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sim.scene, "build_street", build_once)
        yield
    look.cache_clear()


@cache
def look(condition: str, renderer_name: RendererName) -> Image:
    """Return what one camera sees in a condition."""
    camera, settings = CONDITIONS[condition]
    scenario = load_scenario("urban_bend", (*STREET, f"renderer={renderer_name}", *settings))
    scene = sim.scene.build_scene(scenario.world, scenario.rig, 0)
    stage = Stage(scene, scenario.world.drive)
    assert scene.atmosphere is not None
    air = OnBoardAtmosphere(scene.atmosphere, scene.model, stage.at)
    cameras = CameraArray({camera: scene.lenses[camera]}, scenario.world.sensor, 0, air)
    with open_renderer(renderer_name, scene.model) as renderer:
        return cameras.take(stage, renderer, 0, INSTANT_S)[camera]


@pytest.mark.parametrize(("condition", "name"), PAIRS)
def test_pictures_are_alike_whoever_draws_them(condition: str, name: RendererName) -> None:
    ours, theirs = (
        cv2.GaussianBlur(look(condition, each), (0, 0), 3).astype(float) for each in ("classic", name)
    )
    likeness = float(np.corrcoef(ours.ravel(), theirs.ravel())[0, 1])
    brighter = float(theirs.mean() / ours.mean())
    print(f"{condition} by {name}: correlation {likeness:.3f}, {brighter:.2f} times as bright")
    assert likeness > 0.85
    assert 0.75 < brighter < 1.33
