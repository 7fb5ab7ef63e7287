"""Simulate a drive: physics, pictures, lens, sensor; yields bundles with their truth."""

from __future__ import annotations

from collections.abc import Generator, Mapping

import cv2
import mujoco
import numpy as np

from estimator.bundle import FrameBundle, Image
from estimator.rig import Rig
from sim.rendering.classic import ClassicRenderer, RgbImage
from sim.scene import build_scene
from sim.seeds import rng_for
from sim.sensing.lens import GreyImage, Lens
from sim.sensing.sensor import SensorConfig, expose
from sim.vehicle.cameras import world_from_cam
from sim.vehicle.drive import drive, velocity_in_ego, world_from_ego
from sim.world import Snapshot, Truth, WorldConfig

_LUMA = np.array([[0.299, 0.587, 0.114]], np.float32)  # ITU-R BT.601


def simulate(config: WorldConfig, rig: Rig, seed: int) -> Generator[Snapshot, None, None]:
    """Drive once and yield every bundle with its truth.

    Close the generator, or exhaust it, to free the renderer.

    Args:
        config: The world.
        rig: Nominal; the true extrinsics are off by the configured miscalibration.
        seed: Everything random follows from it.
    """
    scene = build_scene(config, rig, seed)
    data = mujoco.MjData(scene.model)
    sources = {name: lens.source for name, lens in scene.lenses.items()}
    with ClassicRenderer(scene.model, sources) as renderer:
        for index in drive(scene.model, data, config.drive, scene.path_m, scene.car):
            images = take_images(renderer.render(data), scene.lenses, config.sensor, seed, index)
            stamp_ns = config.drive.stamp_ns(index)
            yield Snapshot(FrameBundle(stamp_ns, images), read_truth(scene.model, data, rig, stamp_ns))


def take_images(
    pictures: Mapping[str, RgbImage], lenses: Mapping[str, Lens], sensor: SensorConfig, seed: int, index: int
) -> dict[str, Image]:
    """Pass each camera's picture through its lens and sensor; noise is seeded by camera and bundle."""
    return {
        name: expose(lens.apply(grey(pictures[name])), sensor, rng_for(seed, f"sensor.{name}.{index}"))
        for name, lens in lenses.items()
    }


def grey(picture: RgbImage) -> GreyImage:
    """Return (H, W) luma of an (H, W, 3) picture, unrounded."""
    return np.asarray(cv2.transform(picture.astype(np.float32), _LUMA))


def read_truth(model: mujoco.MjModel, data: mujoco.MjData, rig: Rig, stamp_ns: int) -> Truth:
    """Read the state of car and cameras out of the physics, not out of what was asked for."""
    pose = world_from_ego(data)
    ego_from_world = pose.inverse()
    ego_from_cams = {name: ego_from_world @ world_from_cam(data, name) for name in rig.cameras}
    return Truth(stamp_ns, pose, velocity_in_ego(model, data), ego_from_cams)
