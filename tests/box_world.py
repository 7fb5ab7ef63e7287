"""A small sunlit world of coloured boxes and balls on a plane, for renderers to draw."""

from __future__ import annotations

import mujoco
import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.rendering.names import Quality
from sim.rendering.quality import write_visual_settings
from sim.rendering.view import View

SUN_TOWARD = np.array([0.4, 0.3, -0.87]) / np.linalg.norm([0.4, 0.3, -0.87])
EYE = Camera("pinhole", (240, 160), (150.0, 140.0), (101.3, 90.8))  # off centre, pixels not square


def box_world(quality: Quality = "standard", seed: int = 0) -> mujoco.MjModel:
    """Compile a world that has one free ball, so that something can move."""
    spec, rng = mujoco.MjSpec(), np.random.default_rng(seed)
    spec.visual.headlight.ambient, spec.visual.headlight.diffuse = [0.4, 0.4, 0.4], [0, 0, 0]
    spec.visual.headlight.specular = [0, 0, 0]
    spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX, size=[60, 60, 0.1], pos=[0, 0, -0.1], rgba=[0.5, 0.5, 0.5, 1]
    )
    for position in rng.uniform(-25, 25, (60, 2)):
        size = rng.uniform(0.3, 2.0, 3)
        spec.worldbody.add_geom(
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=size,
            pos=[*position, size[2]],
            rgba=[*rng.uniform([0.2, 0.4, 0.4], [0.6, 1, 1]), 1],  # only the ball is red
        )
    ball = spec.worldbody.add_body(name="ball", pos=[6, 0, 1.5], mocap=True)
    ball.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.5, 0, 0], rgba=[0.9, 0.2, 0.1, 1])
    spec.worldbody.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        castshadow=True,
        diffuse=[0.9, 0.9, 0.9],
        pos=-100 * SUN_TOWARD,
        dir=SUN_TOWARD,
    )
    write_visual_settings(spec, EYE.size_px, quality)
    return spec.compile()


def looking(yaw_deg: float, height_m: float = 1.5) -> SE3:
    """Return a camera over the origin that looks along a yaw, level."""
    yaw = np.radians(yaw_deg)
    forward = np.array([np.cos(yaw), np.sin(yaw), 0.0])
    right = np.array([np.sin(yaw), -np.cos(yaw), 0.0])
    return SE3(np.column_stack([right, [0.0, 0.0, -1.0], forward]), np.array([0.0, 0.0, height_m]))


VIEWS = {
    "ahead": View(EYE, looking(0)),
    "left": View(EYE, looking(80) @ SE3.exp(np.array([0.1, 0.2, 0.3, 0, 0, 0]))),
}
