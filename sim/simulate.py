"""Simulate a drive: physics, pictures, lens, sensor; yields bundles with their truth."""

from __future__ import annotations

from collections.abc import Generator

from estimator.rig import Rig
from sim.channels.channels import ChannelMaker
from sim.drive_end import check_times
from sim.faults.chain import FaultChain
from sim.faults.own_clocks import CamerasOnClocks
from sim.light.on_board import OnBoardAtmosphere
from sim.rendering.choice import open_renderer
from sim.scene import Scene, build_scene
from sim.sensing.capture import CameraArray
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam
from sim.vehicle.car_sensors import CarSensors
from sim.vehicle.car_state import velocity_in_ego, world_from_ego
from sim.world import CLOCK_START_NS, Snapshot, Truth, WorldConfig


def simulate(config: WorldConfig, rig: Rig, seed: int) -> Generator[Snapshot, None, None]:
    """Drive once and yield every bundle with its truth.

    Close the generator, or exhaust it, to free the renderer.

    Args:
        config: The world.
        rig: Nominal; the true extrinsics are off by the configured miscalibration.
        seed: Everything random follows from it.
    """
    check_times(config, seed)
    faults = FaultChain(config.faults, rig.cameras, seed)
    scene = build_scene(config, rig, seed)
    stage = Stage(scene, config.drive)
    air = None
    if scene.atmosphere is not None:
        air = OnBoardAtmosphere(scene.atmosphere, scene.model, stage.at, scene.traffic)
    sensors = CarSensors(config.inertial, stage.motion, scene.car, seed)
    cameras = CamerasOnClocks(
        scene.lenses, lambda lenses: CameraArray(lenses, config.sensor, seed, air), config.faults
    )
    with (
        open_renderer(config.renderer, scene.model) as renderer,
        ChannelMaker(config.truth, scene) as maker,
    ):
        count = stage.plan.bundle_count(config.drive.rate_hz)
        for index in range(count):
            time_s = config.drive.time_s(index)
            samples = sensors.until(time_s)
            images = cameras.take(stage, renderer, index, time_s)
            truth = read_truth(scene, stage, time_s)
            frames = faults.pass_on(Snapshot.taken(truth, images).frames, index, time_s)
            next_s = config.drive.time_s(index + 1) if index + 1 < count else None
            channels = maker.at(stage, time_s, next_s)
            yield Snapshot(truth, frames, faults.lasting(time_s), samples, count, channels)


def read_truth(scene: Scene, stage: Stage, time_s: float) -> Truth:
    """Read the state of car and cameras out of the physics, not out of what was asked for."""
    data = stage.at(time_s)
    pose = world_from_ego(data)
    ego_from_world = pose.inverse()
    ego_from_cams = {name: ego_from_world @ world_from_cam(data, name) for name in scene.lenses}
    stamp_ns = CLOCK_START_NS + round(time_s * 1e9)
    return Truth(stamp_ns, pose, velocity_in_ego(scene.model, data), ego_from_cams)
