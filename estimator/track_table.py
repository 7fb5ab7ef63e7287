"""The live tracks of one camera, as a table: ids, pixels, rays, where each was first seen, and its point.

Parallel arrays, so that the work for a frame is a handful of array operations however many tracks there are.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from estimator.se3 import SE3, Array
from estimator.two_rays import midpoints

Chosen = npt.NDArray[np.bool_]
_FIELDS: dict[str, tuple[tuple[int, ...], float]] = {  # the shape of a row, and what stands there at first
    "ids": ((), 0),
    "pixels": ((2,), 0.0),
    "previous_pixels": ((2,), 0.0),
    "rays_cam": ((3,), 0.0),
    "anchor_pixels": ((2,), 0.0),
    "anchor_rays_cam": ((3,), 0.0),
    "anchor_rotation": ((3, 3), 0.0),
    "anchor_center_world": ((3,), np.nan),
    "points_world": ((3,), np.nan),
    "fresh": ((), False),
    "strikes": ((), 0),
    "on_car": ((), False),
}


class TrackTable:
    """N tracks; every attribute has one row a track.

    Attributes:
        ids: (N,) the track's number, never given twice.
        pixels: (N, 2) where the newest image shows it.
        previous_pixels: (N, 2) where the image before it did.
        rays_cam: (N, 3) unit rays of ``pixels``.
        anchor_pixels: (N, 2) where the track was first seen.
        anchor_rays_cam: (N, 3) unit rays of ``anchor_pixels``.
        anchor_rotation: (N, 3, 3) rotation of the camera in the world at that time.
        anchor_center_world: (N, 3) its centre in metres; NaN while unknown.
        points_world: (N, 3) the point in metres; NaN while unknown.
        fresh: (N,) whether the first view has no pose yet.
        strikes: (N,) how many times in a row the motion of the car denied the track.
        on_car: (N,) whether it has stood still so far where no point of the street could have.
    """

    ids: npt.NDArray[np.int64]
    pixels: Array
    previous_pixels: Array
    rays_cam: Array
    anchor_pixels: Array
    anchor_rays_cam: Array
    anchor_rotation: Array
    anchor_center_world: Array
    points_world: Array
    fresh: Chosen
    strikes: npt.NDArray[np.int64]
    on_car: Chosen

    def __init__(self) -> None:
        self._next_id = 0
        self.clear()

    def __len__(self) -> int:
        return len(self.ids)

    def clear(self) -> None:
        """Drop all tracks; their ids stay used."""
        self._allocate(0)

    def keep(self, chosen: Chosen) -> None:
        """Drop the tracks that are not chosen."""
        for name in _FIELDS:
            setattr(self, name, getattr(self, name)[chosen])

    def start(self, pixels: Array, rays_cam: Array) -> None:
        """Append tracks that begin at (N, 2) pixels and their (N, 3) rays."""
        count = len(pixels)
        old = {name: getattr(self, name) for name in _FIELDS}
        self._allocate(count)
        self.ids = np.arange(self._next_id, self._next_id + count)
        self._next_id += count
        self.pixels = self.previous_pixels = self.anchor_pixels = pixels
        self.rays_cam = self.anchor_rays_cam = rays_cam
        self.fresh = np.ones(count, bool)
        for name in _FIELDS:
            setattr(self, name, np.concatenate([old[name], getattr(self, name)]))

    def reanchor(self) -> None:
        """Count all tracks as first seen now."""
        self.anchor_rays_cam, self.anchor_pixels = self.rays_cam.copy(), self.pixels.copy()
        self.points_world[:] = np.nan
        self.fresh[:] = True

    def anchor(self, world_from_cam: SE3) -> None:
        """Note where the newest tracks were first seen."""
        self.anchor_rotation[self.fresh] = world_from_cam.rotation
        self.anchor_center_world[self.fresh] = world_from_cam.translation
        self.fresh[:] = False

    def locate(self, world_from_cam: SE3, min_parallax_rad: float) -> None:
        """Intersect each track's first ray with its newest one where the angle between them allows."""
        first = np.einsum("nij,nj->ni", self.anchor_rotation, self.anchor_rays_cam)
        last = self.rays_cam @ world_from_cam.rotation.T
        points = midpoints(
            first, self.anchor_center_world, last, world_from_cam.translation, min_parallax_rad
        )
        good = np.isfinite(points[:, 0])
        self.points_world[good] = points[good]

    @property
    def located(self) -> Chosen:
        """(N,) whether the place of each track's point is known."""
        return np.asarray(np.isfinite(self.points_world).all(1))

    def judge(self, agrees: Chosen, max_strikes: int) -> None:
        """Take what the motion of the car says of the located tracks, and drop those it keeps denying."""
        located = self.located
        self.strikes[located] = np.where(agrees, 0, self.strikes[located] + 1)
        self.keep(self.strikes < max_strikes)

    def move_world(self, new_from_old: SE3, scale: float, origin_world: Array) -> None:
        """Take over a correction of the world: scaled about a point, then moved."""
        for points in (self.points_world, self.anchor_center_world):
            points[:] = new_from_old.apply(origin_world + scale * (points - origin_world))
        self.anchor_rotation = new_from_old.rotation @ self.anchor_rotation

    def _allocate(self, count: int) -> None:
        for name, (shape, fill) in _FIELDS.items():
            setattr(self, name, np.full((count, *shape), fill))
