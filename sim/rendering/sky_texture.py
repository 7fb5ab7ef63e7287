"""The sky painted around a model: its six faces, and its colour in any direction."""

from __future__ import annotations

import mujoco
import numpy as np

from estimator.se3 import Array
from sim.rendering.view import RgbImage

_GL_FROM_WORLD = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])  # the sky's own up is +y


def skybox_of(model: mujoco.MjModel) -> RgbImage | None:
    """Return faces right, left, up, down, front, back, one above the other; (6 N, N, 3), or None."""
    boxes = np.flatnonzero(model.tex_type == mujoco.mjtTexture.mjTEXTURE_SKYBOX.value)
    if len(boxes) == 0:
        return None
    box = int(boxes[0])
    shape = (int(model.tex_height[box]), int(model.tex_width[box]), int(model.tex_nchannel[box]))
    first = int(model.tex_adr[box])
    faces = np.asarray(model.tex_data[first : first + int(np.prod(shape))]).reshape(shape)[..., :3]
    if shape[0] == shape[1]:
        return np.tile(faces, (6, 1, 1))
    return faces


def sky_color(faces: RgbImage, rays_world: Array) -> RgbImage:
    """Return the sky's colour along (..., 3) world directions, the nearest texel each; (..., 3)."""
    side = faces.shape[1]
    ray = np.asarray(rays_world) @ _GL_FROM_WORLD.T
    x, y, z = ray[..., 0], ray[..., 1], ray[..., 2]
    size = np.abs(ray)
    axis = size.argmax(-1)
    longest = size.max(-1)
    face = 2 * axis + (np.take_along_axis(ray, axis[..., None], -1)[..., 0] < 0)
    u = np.choose(face, [-z, z, x, x, x, -x]) / longest
    v = np.choose(face, [y, y, -z, z, y, y]) / longest
    column = np.clip(((u + 1) / 2 * side).astype(int), 0, side - 1)
    row = np.clip(((1 - v) / 2 * side).astype(int), 0, side - 1)
    return np.asarray(faces[face * side + row, column])
