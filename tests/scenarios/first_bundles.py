"""The first two bundles of a scenario in a quarter of its resolution: enough to see whether it is sound."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import closing
from dataclasses import replace
from itertools import islice

from estimator.camera import Camera
from estimator.rig import MountedCamera
from estimator.rig_file import rig_to_yaml
from scenarios.load import load_scenario
from scenarios.scenario import Scenario
from sim.faults.chain import FaultChain
from sim.faults.clock_faults import ClockOffset
from sim.faults.wrong_intrinsics import WrongIntrinsics
from sim.simulate import simulate
from sim.world import Snapshot, WorldConfig

BUNDLES = 2
SHRINKING = 4


def same_pictures(names: Iterable[str]) -> list[list[str]]:
    """Group scenarios that differ in nothing but faults laid over their pictures.

    Such a group is rendered once, since building the street is nearly all the work.
    """
    groups: dict[str, list[str]] = {}
    for name in names:
        scenario = load_scenario(name)
        key = rig_to_yaml(scenario.rig) + _as_taken(scenario).model_dump_json()
        groups.setdefault(key, []).append(name)
    return list(groups.values())


def first_bundles(names: Sequence[str]) -> dict[str, list[Snapshot]]:
    """Simulate the first bundles of scenarios that show the same, seed 0, each with its own faults."""
    scenarios = [shrunk(load_scenario(name)) for name in names]
    with closing(simulate(_as_taken(scenarios[0]), scenarios[0].rig, 0)) as snapshots:
        sound = list(islice(snapshots, BUNDLES))
    return {scenario.name: _with_faults(scenario, sound) for scenario in scenarios}


def _with_faults(scenario: Scenario, sound: Iterable[Snapshot]) -> list[Snapshot]:
    chain = FaultChain(scenario.world.faults, scenario.rig.cameras, 0)
    times_s = [scenario.world.drive.time_s(index) for index in range(BUNDLES)]
    return [
        Snapshot(snapshot.truth, chain.pass_on(snapshot.frames, index, time_s), chain.lasting(time_s))
        for index, (snapshot, time_s) in enumerate(zip(sound, times_s, strict=True))
    ]


def _as_taken(scenario: Scenario) -> WorldConfig:
    """Return the world with those faults only that change how pictures are taken."""
    taken = [fault for fault in scenario.world.faults if isinstance(fault, (WrongIntrinsics, ClockOffset))]
    return scenario.world.model_copy(update={"faults": taken})


def shrunk(scenario: Scenario) -> Scenario:
    """Return a scenario whose cameras have a quarter of the pixels a side."""
    cameras = {
        name: MountedCamera(_small(mounted.camera), mounted.ego_from_cam)
        for name, mounted in scenario.rig.cameras.items()
    }
    return replace(scenario, rig=replace(scenario.rig, cameras=cameras))


def _small(camera: Camera) -> Camera:
    return replace(
        camera,
        size_px=(camera.size_px[0] // SHRINKING, camera.size_px[1] // SHRINKING),
        focal_px=(camera.focal_px[0] / SHRINKING, camera.focal_px[1] / SHRINKING),
        center_px=tuple((center + 0.5) / SHRINKING - 0.5 for center in camera.center_px),  # type: ignore[arg-type]
    )
