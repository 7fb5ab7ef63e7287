from __future__ import annotations

import mujoco
import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.rendering.culling import in_view

SOURCE = Camera("pinhole", (320, 200), (150.0, 160.0), (170.0, 90.0))
WORLD_FROM_CAM = SE3.exp(np.array([0.4, -0.8, 0.3, 1.0, 2.0, -0.5]))


def test_keeps_every_ball_that_touches_the_image_and_drops_those_behind() -> None:
    rng = np.random.default_rng(0)
    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 1])
    for center in rng.uniform(-20, 20, (500, 3)):
        spec.worldbody.add_geom(pos=center, size=[0.5, 0, 0])
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    kept = in_view(model, data, SOURCE, WORLD_FROM_CAM)
    surface = rng.standard_normal((1, 200, 3))
    surface *= 0.5 / np.linalg.norm(surface, axis=2, keepdims=True)
    points_cam = WORLD_FROM_CAM.inverse().apply(data.geom_xpos[1:, None] + surface)
    seen = SOURCE.contains(SOURCE.project(points_cam.reshape(-1, 3))).reshape(500, 200).any(axis=1)
    assert kept[0]  # a plane has no bounding sphere
    assert kept[1:][seen].all()
    assert not kept[1:][points_cam[..., 2].max(axis=1) < -1.5].any()
    assert 0.05 < kept[1:].mean() < 0.5
