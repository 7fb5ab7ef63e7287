"""Which pinholes to render for a lens: one flat picture, or faces of a cube for a lens too wide for one."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import SE3, Array
from sim.sensing.face import BORDER_PX, Face

SOURCE_DENSITY = 1.1  # source pixels per lens pixel at the sharpest place, so that nothing is lost to blur
# Right, down and forward of each face in the camera's frame; the first looks along the axis.
_CUBE_CAM_FROM_FACE = tuple(
    SE3(np.column_stack([right, down, np.cross(right, down)]).astype(float))
    for right, down in (
        ((1, 0, 0), (0, 1, 0)),
        ((0, 0, 1), (0, 1, 0)),
        ((0, 0, -1), (0, 1, 0)),
        ((1, 0, 0), (0, 0, 1)),
        ((1, 0, 0), (0, 0, -1)),
        ((-1, 0, 0), (0, 1, 0)),
    )
)


def flat_face(plane: Array, samples_a_side: int) -> Face:
    """Return the one face of a lens whose (rows, columns, 2) samples look at these points at depth one."""
    density_px = SOURCE_DENSITY * _sharpest_px(plane, samples_a_side)
    rows, columns = plane.shape[:2]
    return _face(SE3(np.eye(3)), (slice(0, rows), slice(0, columns)), plane, (density_px, density_px), None)


def cube_faces(rays: Array, samples_a_side: int) -> tuple[Face, ...]:
    """Return the faces that (rows, columns, 3) rays of samples in the camera's frame pierce.

    The faces part the samples exactly, and meet at equal angles and equal resolution, so that no seam shows.
    """
    closest = np.argmax([rays @ pose.rotation[:, 2] for pose in _CUBE_CAM_FROM_FACE], axis=0)
    return tuple(_faces_hit(rays, closest, samples_a_side))


def _faces_hit(rays: Array, closest: npt.NDArray[np.intp], samples_a_side: int) -> Iterator[Face]:
    for index, cam_from_face in enumerate(_CUBE_CAM_FROM_FACE):
        served = closest == index
        if not served.any():
            continue
        block = _block(served)
        served = served[block]
        rays_face = rays[block] @ cam_from_face.rotation
        depth = np.where(served, rays_face[..., 2], 1.0)
        plane = rays_face[..., :2] / depth[..., None]
        focal_px = _densities_px(plane, served, samples_a_side)
        yield _face(cam_from_face, block, plane, focal_px, served)


def _block(served: npt.NDArray[np.bool_]) -> tuple[slice, slice]:
    rows, columns = (np.flatnonzero(served.any(axis)) for axis in (1, 0))
    return slice(int(rows[0]), int(rows[-1]) + 1), slice(int(columns[0]), int(columns[-1]) + 1)


def _face(
    cam_from_face: SE3,
    block: tuple[slice, slice],
    plane: Array,
    focal_px: tuple[float, float],
    served: npt.NDArray[np.bool_] | None,
) -> Face:
    """Return the face that just covers its samples; ``plane`` is where they look at depth one."""
    places = plane.reshape(-1, 2) if served is None else plane[served]
    low, high = places.min(0), places.max(0)
    focal = np.array(focal_px)
    center_px = BORDER_PX - low * focal
    size_px = np.ceil((high - low) * focal + 2 * BORDER_PX).astype(int) + 1
    pinhole = Camera(
        "pinhole",
        (int(size_px[0]), int(size_px[1])),
        (float(focal[0]), float(focal[1])),
        (float(center_px[0]), float(center_px[1])),
    )
    return Face(pinhole, cam_from_face, block, (plane * focal + center_px).astype(np.float32), served)


def _sharpest_px(plane: Array, samples_a_side: int) -> float:
    """Return the lens's finest resolution, in lens pixels per unit of the plane at depth one."""
    across = np.linalg.norm(np.diff(plane, axis=1), axis=-1).min()
    down = np.linalg.norm(np.diff(plane, axis=0), axis=-1).min()
    return float(1 / (samples_a_side * min(across, down)))


def _densities_px(plane: Array, served: npt.NDArray[np.bool_], samples_a_side: int) -> tuple[float, float]:
    """Return source pixels per unit of the plane, right and down, that the finest place of a face needs.

    A wide fisheye is finer around its axis than away from it, so the two differ on the faces at its sides.
    """
    whole = served[:-1, :-1] & served[1:, :-1] & served[:-1, 1:]
    across = np.diff(plane, axis=1)[:-1][whole]  # of the plane, for a step of one sample
    down = np.diff(plane, axis=0)[:, :-1][whole]
    if not len(across):
        across, down = np.array([[0.01, 0.0]]), np.array([[0.0, 0.01]])
    area = np.abs(across[:, 0] * down[:, 1] - across[:, 1] * down[:, 0])
    # Columns of the inverse Jacobian: samples for a step of one along either axis of the plane.
    right = np.hypot(across[:, 1], down[:, 1]) / area
    below = np.hypot(across[:, 0], down[:, 0]) / area
    scale = SOURCE_DENSITY / samples_a_side
    return float(scale * right.max()), float(scale * below.max())
