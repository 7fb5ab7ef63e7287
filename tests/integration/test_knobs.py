"""One knob changes what it names, and only that.

Each setting is turned alone on a short drive of three tiny cameras, and every aspect of what comes out is
compared: the car's path, the cameras' mounting, the things along the street, the images, their stamps, and
the car's other sensors.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from functools import cache
from itertools import islice
from typing import Any

import numpy as np
import pytest

import sim.scene
import sim.simulate
from scenarios.load import load_scenario
from sim.rendering.choice import probe
from sim.sensing.refit import with_lenses
from sim.world import WorldConfig
from tests.integration.test_recorder import RIG
from tests.settings import all_settings

Aspects = Mapping[str, Mapping[str, Any]]

BASE = (
    "street.length_m=25",
    "street.vegetation=0.5",
    "drive.distance_m=5",
    "inertial={}",
    "weather={sun_elevation_deg: 12, sun_azimuth_deg: 10}",  # in sight of the front camera
)
ELSEWHERE = {  # where a knob tells that would not on the base's street
    "weather.tunnel": ("street.kind=tunnel", "street.length_m=50"),
    "drive.grip": ("drive.profile=hard_braking", "drive.rate_hz=1"),
    "drive.lateral_mps2": (
        "street.kind=t_junction",
        "street.length_m=60",
        "drive.distance_m=45",
        "drive.speed_mps=12",
        "drive.rate_hz=1",
    ),
    "sensor.exposure": ("weather.night=3",),
}
COUNT = 2
_SAME = 1e-9  # m and rad: rounding on the way through the world's frame
SEEN = {"images"}
# By setting: another value, what it must change, and what it may change besides.
KNOBS: dict[str, tuple[str, set[str], set[str]]] = {
    "street.kind": ("straight", {"scenery", "images"}, {"path", "samples"}),
    "street.length_m": ("40", {"scenery", "images"}, {"path", "samples"}),
    "street.facades": ("bare", {"scenery", "images"}, set()),
    "street.parking": ("0", {"scenery", "images"}, set()),
    "street.vegetation": ("1", {"scenery", "images"}, set()),
    "street.slope_percent": ("8", {"path", "scenery", "images", "samples"}, set()),
    "street.speed_bumps": ("10", {"scenery", "images"}, {"path", "samples"}),
    "street.roughness": ("4", {"path", "samples", "images"}, {"scenery"}),
    "street.traffic.cars": ("4", SEEN, {"scenery"}),
    "street.traffic.cyclists": ("4", SEEN, {"scenery"}),
    "street.traffic.pedestrians": ("4", SEEN, {"scenery"}),
    "drive.speed_mps": ("7", {"path", "images", "samples", "length"}, set()),
    "drive.distance_m": ("4", {"length"}, set()),
    "drive.rate_hz": ("20", {"stamps", "length"}, {"path", "images", "samples"}),
    "drive.profile": ("pull_away", {"path", "images", "samples", "length"}, set()),
    "drive.reverse": ("true", {"path", "images", "samples"}, set()),
    "drive.grip": ("0.3", {"path", "samples", "images"}, {"length"}),
    "drive.lateral_mps2": ("0.2", {"path", "images", "samples", "length"}, set()),
    "miscalibration.rotation_deg": ("1", {"mounting", "images"}, set()),
    "miscalibration.translation_mm": ("10", {"mounting", "images"}, set()),
    "miscalibration.events": (
        "[{kind: knock, camera: rear, at_s: 0.05, rotation_deg: 1}]",
        {"mounting", "images"},
        set(),
    ),
    **{
        f"weather.{name}": (value, SEEN, set())
        for name, value in {
            "sun_elevation_deg": "40",
            "sun_azimuth_deg": "200",
            **dict.fromkeys(("overcast", "dusk", "night", "fog", "rain", "wet_lens", "flare"), "3"),
        }.items()
    },
    "weather.tunnel": ("3", SEEN, set()),
    **{
        f"sensor.{name}": (value, SEEN, set())
        for name, value in {
            "noise": "3",
            **dict.fromkeys(("blur", "motion_blur", "vignetting", "dirt", "jpeg"), "4"),
            "rolling_shutter_s": "0.03",
        }.items()
    },
    "sensor.exposure": ("fixed", SEEN, set()),
    "sensor.lens": ("brown_conrady", SEEN, set()),
    "inertial.rate_hz": ("100", {"samples"}, set()),
    "inertial.noise": ("4", {"samples"}, set()),
    "inertial.bias": ("4", {"samples"}, set()),
    "faults": ("[{kind: black, camera: rear}]", SEEN, set()),
    "renderer": ("pyrender", SEEN, set()),
    "quality": ("draft", SEEN, set()),
    "truth": ("[depth]", {"channels"}, set()),
}


@pytest.fixture(scope="module", autouse=True)
def base_street_built_once() -> Iterator[None]:
    """Build the base's street once: what asks for the same with the same generator gets the same."""
    build = sim.scene.build_street
    built: dict[str, Any] = {}  # the first one, which is the base's

    def build_once(config: Any, rng: np.random.Generator) -> Any:
        key = f"{config.model_dump_json()} {rng.bit_generator.state}"
        if not built:
            built[key] = build(config, rng)
        return built[key] if key in built else build(config, rng)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sim.scene.build_street", build_once)
        yield


@cache
def aspects(*settings: str) -> Aspects:
    """Simulate the first bundles and return what came out, by aspect and there by what it belongs to."""
    world = load_scenario("first_drive", [*BASE, *settings]).world
    rig = RIG if world.sensor.lens == "nominal" else with_lenses(RIG, world.sensor.lens)
    scenes: list[Any] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sim.simulate.build_scene", _noting(sim.simulate.build_scene, scenes))
        with closing(sim.simulate.simulate(world, rig, seed=0)) as drive:
            snapshots = list(islice(drive, COUNT))
    model = scenes[0].model
    return {
        "path": {s.truth.stamp_ns: s.truth.world_from_ego.matrix for s in snapshots},
        "mounting": {
            (s.truth.stamp_ns, name): pose.matrix
            for s in snapshots
            for name, pose in s.truth.ego_from_cams.items()
        },
        "scenery": dict.fromkeys(_meshes(model), True),
        "images": {(f.stamp_ns, f.camera): f.image for s in snapshots for f in s.frames},
        "stamps": {f.stamp_ns: f.arrival_ns for s in snapshots for f in s.frames},
        "samples": {s.truth.stamp_ns: repr(s.samples) for s in snapshots},
        "channels": {s.truth.stamp_ns: s.channels is None for s in snapshots},
        "length": {"bundles": snapshots[0].bundle_count},
    }


def _noting(build: Callable[..., Any], scenes: list[Any]) -> Callable[..., Any]:
    def build_and_note(*arguments: Any) -> Any:
        scenes.append(build(*arguments))
        return scenes[-1]

    return build_and_note


def _meshes(model: Any) -> Iterator[str]:
    for index in range(model.nmesh):
        first, count = model.mesh_vertadr[index], model.mesh_vertnum[index]
        points_m = model.mesh_vert[first : first + count].round(6)
        yield hashlib.sha256(points_m.tobytes()).hexdigest()


def changed(before: Aspects, after: Aspects) -> set[str]:
    """Return the aspects that differ; images and poses where both drives have one of the same instant."""
    return {name for name in before if _differ(before[name], after[name], name in ("scenery", "stamps"))}


def _differ(before: Mapping[Any, Any], after: Mapping[Any, Any], wholly: bool) -> bool:
    if wholly:
        return before != after
    shared = before.keys() & after.keys()
    assert shared, "nothing to compare"
    return not all(_equal(before[key], after[key]) for key in shared)


def _equal(before: Any, after: Any) -> bool:
    if isinstance(before, np.ndarray) and before.dtype.kind == "f":
        return bool(np.abs(before - after).max() < _SAME)
    return bool(np.array_equal(before, after))


def test_every_setting_of_a_world_is_turned() -> None:
    paths = {setting.path for setting in all_settings(WorldConfig)}
    assert {path.partition("[")[0] for path in paths} == set(KNOBS)


@pytest.mark.parametrize("path", KNOBS)
def test_a_knob_changes_what_it_names_and_nothing_else(path: str) -> None:
    value, wanted, allowed = KNOBS[path]
    where = ELSEWHERE.get(path, ())
    before = aspects(*where)
    if path == "renderer" and probe(value).problem:  # type: ignore[arg-type]
        pytest.skip(f"this machine has no {value}")
    got = changed(before, aspects(*where, f"{path}={value}"))
    assert wanted <= got <= wanted | allowed


def test_the_same_settings_change_nothing() -> None:
    again = aspects("drive.rate_hz=10")
    assert again is not aspects() and changed(aspects(), again) == set()
