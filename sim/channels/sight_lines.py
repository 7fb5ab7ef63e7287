"""The viewing ray of every pixel of one camera, and where a lens's source pictures show what it meets.

Exact, unlike the images themselves: one ray a pixel, through its centre; nothing is averaged.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import Array
from sim.rendering.geom_picture import SKY, GeomImage, GeomPicture
from sim.sensing.lens import Lens

_SAME_SURFACE = 0.02  # bend of inverse depth between neighbours, as a share


@dataclass(frozen=True, eq=False)
class SightLines:
    """Where to look for each of a camera's N pixels, row by row.

    Attributes:
        size_px: Width and height of the image.
        rays_cam: (N, 3) unit rays.
        face: (N,) index of the lens's face that serves the pixel.
        source_px: (N, 2) place in that face's picture.
        axis_share: (N,) cosine between the ray and that face's axis.
    """

    size_px: tuple[int, int]
    rays_cam: Array
    face: npt.NDArray[np.int64]
    source_px: Array
    axis_share: Array

    def gather(self, pictures: Sequence[GeomPicture]) -> tuple[GeomImage, Array]:
        """Return (N,) geoms and (N,) distances along the rays in metres, infinite for the sky."""
        geom = np.full(len(self.face), SKY, np.int32)
        inverse_depth = np.zeros(len(self.face))
        for index, picture in enumerate(pictures):
            mine = self.face == index
            geom[mine], inverse_depth[mine] = _look_up(picture, self.source_px[mine])
        with np.errstate(divide="ignore"):
            range_m = np.where(geom == SKY, np.inf, 1 / (inverse_depth * self.axis_share))
        return geom, range_m


def sight_lines(camera: Camera, lens: Lens) -> SightLines:
    """Find for every pixel the face whose axis is nearest to its ray."""
    width, height = camera.size_px
    pixels = np.stack(np.meshgrid(np.arange(width), np.arange(height)), -1).reshape(-1, 2).astype(float)
    rays_cam = camera.unproject(pixels)
    rays_of_faces = [rays_cam @ face.cam_from_face.rotation for face in lens.faces]
    places = [_project(face.pinhole, rays) for face, rays in zip(lens.faces, rays_of_faces, strict=True)]
    shares = np.array([rays[:, 2] for rays in rays_of_faces])
    inside = np.array([np.isfinite(place).all(1) for place in places])
    best = np.where(inside, shares, -np.inf).argmax(0)
    each = np.arange(len(pixels))
    return SightLines(camera.size_px, rays_cam, best, np.array(places)[best, each], shares[best, each])


def _project(pinhole: Camera, rays: Array) -> Array:
    """Return (N, 2) pixels; NaN behind and outside the picture."""
    with np.errstate(divide="ignore", invalid="ignore"):
        pixels = rays[:, :2] / rays[:, 2:] * pinhole.focal_px + np.array(pinhole.center_px)
        limits = np.array(pinhole.size_px) - 0.5
        seen = (rays[:, 2] > 0) & ((pixels >= -0.5) & (pixels <= limits)).all(1)
    return np.where(seen[:, None], pixels, np.nan)


def _look_up(picture: GeomPicture, places_px: Array) -> tuple[GeomImage, Array]:
    """Return the geom of the nearest pixel, and inverse depth at the very place.

    Inverse depth is linear in a flat picture of a plane: between four pixels of one smooth surface it is
    interpolated, which is exact on planes; elsewhere the nearest pixel's is taken.
    """
    height, width = picture.geom.shape
    nearest = np.clip(np.rint(places_px).astype(int), 0, [width - 1, height - 1])
    geom = picture.geom[nearest[:, 1], nearest[:, 0]]
    inverse = 1 / picture.depth_m.astype(float)
    low = np.clip(np.floor(places_px).astype(int), 0, [width - 2, height - 2])
    across, down = (places_px - low).T
    corners = [(low[:, 1] + v, low[:, 0] + u) for v in (0, 1) for u in (0, 1)]
    values = np.stack([inverse[corner] for corner in corners])
    alike = np.all([picture.geom[corner] == geom for corner in corners], axis=0)
    bend = np.abs(values[0] + values[3] - values[1] - values[2])
    smooth = alike & (bend < _SAME_SURFACE * values.max(0)) & (np.ptp(values, axis=0) < 0.2 * values.max(0))
    weights = np.stack([(1 - down) * (1 - across), (1 - down) * across, down * (1 - across), down * across])
    return geom, np.where(smooth, (weights * values).sum(0), inverse[nearest[:, 1], nearest[:, 0]])
