"""A dark world with bright balls in it, and where each should appear."""

from __future__ import annotations

from collections.abc import Callable

import mujoco
import numpy as np

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.se3 import SE3, Array
from sim.sensing.shutter import Shutter

_OUTLINE_POINTS = 90
_BLUR_POINTS = 9
_STEP_S = 0.001


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
    return polygon_centroid(outline_px(camera, center_cam, radius_m))


def outline_px(camera: Camera, center_cam: Array, radius_m: float) -> Array:
    """Return (N, 2) pixels around a ball's picture."""
    distance_m = float(np.linalg.norm(center_cam))
    axis = center_cam / distance_m
    side = np.cross(axis, [0.0, 1.0, 0.0] if abs(axis[1]) < 0.9 else [1.0, 0.0, 0.0])
    side /= np.linalg.norm(side)
    turn = np.linspace(0, 2 * np.pi, _OUTLINE_POINTS, endpoint=False)[:, None]
    half_angle = np.arcsin(radius_m / distance_m)
    rim = np.cos(turn) * side + np.sin(turn) * np.cross(axis, side)
    return camera.project(np.cos(half_angle) * axis + np.sin(half_angle) * rim)


def polygon_centroid(corners: Array) -> Array:
    """Return the centroid of the area inside an (N, 2) polygon."""
    following = np.roll(corners, -1, axis=0)
    cross = corners[:, 0] * following[:, 1] - following[:, 0] * corners[:, 1]
    return np.asarray(((corners + following) * cross[:, None]).sum(0) / (3 * cross.sum()))


def polygon_area(corners: Array) -> float:
    """Return the area inside an (N, 2) polygon."""
    following = np.roll(corners, -1, axis=0)
    return float(abs((corners[:, 0] * following[:, 1] - following[:, 0] * corners[:, 1]).sum()) / 2)


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


def rolling_centroid_px(
    camera: Camera,
    cam_from_world: Callable[[float], SE3],
    center_world: Array,
    radius_m: float,
    shutter: Shutter,
) -> Array:
    """Return the (2,) centroid of a ball's picture when each row is exposed in its turn.

    Args:
        camera: Intrinsics.
        cam_from_world: Pose by time, counted from the middle of the image's exposure.
        center_world: The ball's.
        radius_m: The ball's.
        shutter: Readout and blur; a blurred picture's centroid is the mean over the exposure of a row.
    """
    offsets_s = shutter.blur_s * (np.arange(_BLUR_POINTS) + 0.5 - _BLUR_POINTS / 2) / _BLUR_POINTS
    if not shutter.blur_s:
        offsets_s = np.zeros(1)
    return np.mean(
        [_rolled(camera, cam_from_world, center_world, radius_m, shutter, s) for s in offsets_s], axis=0
    )


def _rolled(
    camera: Camera,
    cam_from_world: Callable[[float], SE3],
    center_world: Array,
    radius_m: float,
    shutter: Shutter,
    offset_s: float,
) -> Array:
    """Let each point of the outline be seen when its own row is exposed; it moves evenly around that time."""
    height_px = camera.size_px[1]
    per_row_s = shutter.readout_s / height_px
    first_s = offset_s + shutter.readout_s * (0.5 / height_px - 0.5)  # of row 0
    time_s = offset_s
    for _ in range(5):
        row = camera.project(cam_from_world(time_s).apply(center_world[None]))[0, 1]
        time_s = first_s + per_row_s * row
    before, outline, after = (
        outline_px(camera, cam_from_world(time_s + s).apply(center_world), radius_m)
        for s in (-_STEP_S, 0.0, _STEP_S)
    )
    rates = (after - before) / (2 * _STEP_S)
    # row = outline row + rate * (time - time_s) with time = first_s + per_row_s * row
    rows = (outline[:, 1] + rates[:, 1] * (first_s - time_s)) / (1 - rates[:, 1] * per_row_s)
    late_s = first_s + per_row_s * rows - time_s
    return polygon_centroid(outline + rates * late_s[:, None])
