"""A dark world with bright balls in it, and where each should appear."""

from __future__ import annotations

import mujoco
import numpy as np

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.se3 import SE3, Array

_OUTLINE_POINTS = 90


def write_balls(spec: mujoco.MjSpec, centers_world: Array, radii_m: Array) -> None:
    """Add white balls that glow, and no other light."""
    spec.visual.headlight.active = 0
    spec.visual.quality.numslices, spec.visual.quality.numstacks = 48, 32
    material = spec.add_material(name="glow", rgba=[1, 1, 1, 1], emission=1.0)
    for center, radius_m in zip(centers_world, radii_m, strict=True):
        spec.worldbody.add_geom(
            type=mujoco.mjtGeom.mjGEOM_SPHERE,
            pos=center,
            size=[radius_m, 0, 0],
            material=material.name,
            contype=0,
            conaffinity=0,
        )


def expected_centroid_px(camera: Camera, center_cam: Array, radius_m: float) -> Array:
    """Return the (2,) centroid of a ball's picture, which is not quite its centre's pixel."""
    distance_m = float(np.linalg.norm(center_cam))
    axis = center_cam / distance_m
    side = np.cross(axis, [0.0, 1.0, 0.0] if abs(axis[1]) < 0.9 else [1.0, 0.0, 0.0])
    side /= np.linalg.norm(side)
    turn = np.linspace(0, 2 * np.pi, _OUTLINE_POINTS, endpoint=False)[:, None]
    half_angle = np.arcsin(radius_m / distance_m)
    rim = np.cos(turn) * side + np.sin(turn) * np.cross(axis, side)
    return polygon_centroid(camera.project(np.cos(half_angle) * axis + np.sin(half_angle) * rim))


def polygon_centroid(corners: Array) -> Array:
    """Return the centroid of the area inside an (N, 2) polygon."""
    following = np.roll(corners, -1, axis=0)
    cross = corners[:, 0] * following[:, 1] - following[:, 0] * corners[:, 1]
    return np.asarray(((corners + following) * cross[:, None]).sum(0) / (3 * cross.sum()))


def measured_centroid_px(picture: Image, near_px: Array, reach_px: int) -> Array:
    """Return the (2,) centroid of brightness within ``reach_px`` of a pixel."""
    column, row = np.rint(near_px).astype(int)
    patch = picture[row - reach_px : row + reach_px + 1, column - reach_px : column + reach_px + 1].astype(
        float
    )
    assert patch.sum() > 255, f"no ball near {near_px}"
    rows, columns = np.mgrid[row - reach_px : row + reach_px + 1, column - reach_px : column + reach_px + 1]
    return np.array([(columns * patch).sum(), (rows * patch).sum()]) / patch.sum()


def balls_in_view(
    camera: Camera, world_from_cam: SE3, radius_px: float, margin_px: int
) -> tuple[Array, Array]:
    """Place a grid of balls over the whole image, at 2 to 9 m; return (N, 3) world centres and (N,) radii."""
    axes = [
        np.linspace(margin_px, length - 1 - margin_px, n)
        for length, n in zip(camera.size_px, (11, 7), strict=True)
    ]
    pixels = np.stack(np.meshgrid(*axes), -1).reshape(-1, 2) + 0.37
    distances_m = 2 + 7 * (np.arange(len(pixels)) * 0.618 % 1)
    rays = camera.unproject(pixels)
    return world_from_cam.apply(rays * distances_m[:, None]), distances_m * radius_px / max(camera.focal_px)
