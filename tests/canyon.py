"""A street of four textured planes, drawn by casting a ray through every pixel: exact and without GL.

Road, two facades and the end of the street. Each texture is kept at several blurs, and every pixel reads the
one that suits its size on the plane, so that nothing flickers as the car moves.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.se3 import SE3, Array

TEXEL_M = 0.02
BLURS = 4
SKY = 210


def noise_image(height: int, width: int, seed: int, octaves: int = 5, finest_px: float = 2.5) -> Image:
    """Return smooth grey noise with detail at several scales."""
    rng = np.random.default_rng(seed)
    total = np.zeros((height, width), np.float32)
    for octave in range(octaves):
        cell = finest_px * 2**octave
        size = (max(2, round(width / cell)), max(2, round(height / cell)))
        grain = rng.standard_normal(size[::-1]).astype(np.float32)
        total += cv2.resize(grain, (width, height), interpolation=cv2.INTER_CUBIC)
    return np.clip(128 + 70 * total / (2 * total.std()), 0, 255).astype(np.uint8)


@dataclass(frozen=True, eq=False)
class Plane:
    """A rectangle in the world: corner, two unit axes with its size along them, and a texture."""

    corner: tuple[float, float, float]
    along: tuple[float, float, float]
    across: tuple[float, float, float]
    size_m: tuple[float, float]
    seed: int

    @cached_property
    def normal(self) -> Array:
        return np.cross(self.along, self.across)

    @cached_property
    def textures(self) -> list[Image]:
        width, height = (round(size / TEXEL_M) for size in self.size_m)
        sharp = noise_image(height, width, self.seed)
        return [sharp] + [cv2.GaussianBlur(sharp, (0, 0), 0.5 * 2.0**blur) for blur in range(1, BLURS)]

    def reach(self, center: Array, rays: Array) -> Array:
        """Return the (N,) distances along unit rays; infinite where they miss."""
        with np.errstate(divide="ignore", invalid="ignore"):
            reach = ((np.array(self.corner) - center) @ self.normal) / (rays @ self.normal)
            inside = self._on_plane(center + reach[:, None] * rays)
            hit = (reach > 0) & (inside > 0).all(1) & (inside < self.size_m).all(1)
        return np.where(hit, reach, np.inf)

    def brightness(self, points: Array, pixel_m: Array) -> Array:
        """Return the (N,) grey values of points, each seen by a pixel of a given width on the plane."""
        where = (self._on_plane(points) / TEXEL_M - 0.5).astype(np.float32)
        rows = np.array_split(where, 1 + len(where) // 30_000)  # OpenCV's remap takes no longer map
        blur = np.clip(np.round(np.log2(np.maximum(pixel_m / TEXEL_M, 1e-6))), 0, BLURS - 1).astype(int)
        values = [
            np.concatenate([cv2.remap(texture, row[None], None, cv2.INTER_LINEAR)[0] for row in rows])
            for texture in self.textures
        ]
        return np.choose(blur, values)

    def _on_plane(self, points: Array) -> Array:
        return (points - self.corner) @ np.column_stack([self.along, self.across])


PLANES = (
    Plane((-15, -6, 0), (1, 0, 0), (0, 1, 0), (55, 12), 1),
    Plane((-15, 6, 0), (1, 0, 0), (0, 0, 1), (55, 9), 2),
    Plane((-15, -6, 0), (1, 0, 0), (0, 0, 1), (55, 9), 3),
    Plane((40, -6, 0), (0, 1, 0), (0, 0, 1), (12, 9), 4),
)


def cast(world_from_cam: SE3, rays_cam: Array) -> tuple[Array, Array]:
    """Return the (N, 3) points that rays meet first, NaN in the sky, and the (N,) index of the plane."""
    center, rays = world_from_cam.translation, rays_cam @ world_from_cam.rotation.T
    reach = np.stack([plane.reach(center, rays) for plane in PLANES])
    nearest = reach.min(0)
    nearest[~np.isfinite(nearest)] = np.nan
    return center + nearest[:, None] * rays, reach.argmin(0)


def render(camera: Camera, world_from_cam: SE3) -> Image:
    """Draw what a camera sees."""
    width, height = camera.size_px
    pixels = np.stack(np.meshgrid(np.arange(width), np.arange(height)), -1).reshape(-1, 2).astype(float)
    points, hit = cast(world_from_cam, camera.unproject(pixels))
    view = points - world_from_cam.translation
    distance = np.linalg.norm(view, axis=1)
    grey = np.full(len(pixels), SKY, np.uint8)
    for index in np.unique(hit[np.isfinite(distance)]):
        plane, mine = PLANES[index], (hit == index) & np.isfinite(distance)
        facing = np.abs(view[mine] @ plane.normal) / distance[mine]
        pixel_m = distance[mine] / camera.focal_px[0] / np.sqrt(np.maximum(facing, 1e-3))
        grey[mine] = plane.brightness(points[mine], pixel_m)
    return grey.reshape(height, width)
