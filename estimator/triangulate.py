"""Intersect viewing rays, many landmarks at once."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from estimator.se3 import Array


def triangulate(
    landmark: npt.NDArray[np.int64], rays_world: Array, centers_world: Array, count: int
) -> tuple[Array, Array]:
    """Intersect the rays of each landmark in the least-squares sense (midpoint).

    Two passes: the second weighs every ray by its inverse squared distance, which turns the distance from
    the ray into an angle.

    Args:
        landmark: (N,) index of the landmark that each ray belongs to.
        rays_world: (N, 3) unit rays.
        centers_world: (N, 3) camera centres in metres.
        count: Number of landmarks.

    Returns:
        (count, 3) points, NaN where rays are parallel or the point lies behind a camera, and (count,)
        the widest angle in rad between the first ray of a landmark and any other.

    Reference:
        Hartley & Sturm 1997, sec. 5.
    """
    normal = np.eye(3) - rays_world[:, :, None] * rays_world[:, None, :]
    weight = np.ones(len(rays_world))
    points = np.full((count, 3), np.nan)
    for _ in range(2):
        weighted = normal * weight[:, None, None]
        hessian = np.zeros((count, 3, 3))
        vector = np.zeros((count, 3))
        np.add.at(hessian, landmark, weighted)
        np.add.at(vector, landmark, np.einsum("nij,nj->ni", weighted, centers_world))
        scale = np.trace(hessian, axis1=1, axis2=2)
        solvable = np.linalg.det(hessian) > 1e-10 * np.maximum(scale, 1e-30) ** 3
        points[:] = np.nan
        points[solvable] = np.linalg.solve(hessian[solvable], vector[solvable, :, None])[..., 0]
        distance2 = ((points[landmark] - centers_world) ** 2).sum(1)
        weight = 1 / np.maximum(np.nan_to_num(distance2, nan=1.0), 0.01)
    depth = np.einsum("ni,ni->n", points[landmark] - centers_world, rays_world)
    behind = np.zeros(count, bool)
    np.logical_or.at(behind, landmark, ~(depth > 0.1))
    points[behind] = np.nan
    return points, _widest_angle(landmark, rays_world, count)


def _widest_angle(landmark: npt.NDArray[np.int64], rays_world: Array, count: int) -> Array:
    first = np.full(count, -1, dtype=np.int64)
    first[landmark[::-1]] = np.arange(len(landmark))[::-1]
    cosine = np.einsum("ni,ni->n", rays_world, rays_world[first[landmark]])
    angle = np.arccos(np.clip(cosine, -1, 1))
    widest = np.zeros(count)
    np.maximum.at(widest, landmark, angle)
    return widest
