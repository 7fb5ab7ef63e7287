"""Exact lens images: finer pinhole pictures of the same view, resampled through the camera model.

A pinhole camera is rendered as it is. A distorted one is rendered by one source pinhole that covers its
whole field, finely enough for the sharpest place of the lens; one too wide for that by the faces of a cube
around its centre of projection. Every pixel is the mean of a grid of samples at the places where
``Camera.unproject`` says its rays meet the sources.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from scipy.interpolate import RectBivariateSpline

from estimator.camera import Camera
from estimator.errors import InputError
from estimator.se3 import SE3, Array
from sim.rendering.view import View
from sim.sensing.face import BORDER_PX, DRIFT_MARGIN_PX, Face, GreyImage, PixelRates
from sim.sensing.sources import cube_faces, flat_face

SAMPLES_A_SIDE = 2  # per pixel: with the renderer's own multisampling enough against aliasing
WIDEST_FLAT_RAD = np.radians(71.0)  # half angle that one source pinhole of sane size can serve
_NODE_SPACING_PX = 8


@dataclass(frozen=True, eq=False)
class Lens:
    """How one camera's image, or some rows of it, is made.

    Attributes:
        size_px: Width and height of the image, or of the rows.
        samples_a_side: Of a pixel.
        faces: The pinholes to render.
    """

    size_px: tuple[int, int]
    samples_a_side: int
    faces: tuple[Face, ...]

    @property
    def source(self) -> Camera:
        """The pinhole of the first face, which looks along the camera's axis in a whole image."""
        return self.faces[0].pinhole

    @property
    def largest_px(self) -> tuple[int, int]:
        """Width and height that no picture rendered for this lens exceeds, strips of rows included."""
        widths, heights = zip(*(face.pinhole.size_px for face in self.faces), strict=True)
        room_px = 2 * (BORDER_PX + DRIFT_MARGIN_PX) + 1
        return max(widths) + room_px, max(heights) + room_px

    def views(self, name: str, world_from_cam: SE3) -> dict[str, View]:
        """Return the view of each face, named after the camera, when the camera has this pose."""
        return {
            key: View(face.pinhole, world_from_cam @ face.cam_from_face)
            for key, face in zip(self.keys(name), self.faces, strict=True)
        }

    def keys(self, name: str) -> tuple[str, ...]:
        """Return the names of the views."""
        return (name, *(f"{name}/{index}" for index in range(1, len(self.faces))))

    def apply(
        self,
        lights: Sequence[GreyImage],
        rates: Sequence[PixelRates] | None = None,
        delay_s: Array | None = None,
    ) -> GreyImage:
        """Turn the light of all faces into the image's light.

        Args:
            lights: One (rows, columns) picture a face.
            rates: One (rows, columns, 2) field a face: how fast what is seen there moves, in px/s.
            delay_s: (H,) how long after those pictures each row of the image is exposed.
        """
        face = self.faces[0]
        if face.exact and rates is None:
            return lights[0]
        width, height = self.size_px
        n = self.samples_a_side
        samples = np.empty((n * height, n * width), np.float32)
        late_s = None if delay_s is None else np.repeat(delay_s, n).astype(np.float32)
        for index, (face, light) in enumerate(zip(self.faces, lights, strict=True)):
            face.paint(samples, light, None if rates is None else rates[index], late_s)
        if n == 1:
            return samples
        return np.asarray(cv2.resize(samples, (width, height), interpolation=cv2.INTER_AREA))

    def rows(self, first: int, last: int, margin_px: int = 0) -> Lens:
        """Return the lens of rows ``first`` to ``last`` (not included) of the image alone."""
        n = self.samples_a_side
        parts = (face.rows(n * first, n * last, margin_px) for face in self.faces)
        faces = tuple(part for part in parts if part is not None)
        return Lens((self.size_px[0], last - first), n, faces)


def make_lens(camera: Camera) -> Lens:
    """Build the lens of a camera.

    Raises:
        InputError: The lens folds over inside the image.
    """
    width, height = camera.size_px
    if camera.model == "pinhole":
        pixels = np.stack(np.meshgrid(np.arange(width), np.arange(height)), -1).astype(np.float32)
        block = (slice(0, height), slice(0, width))
        return Lens(camera.size_px, 1, (Face(camera, SE3(np.eye(3)), block, pixels, exact=True),))
    columns, rows, rays = _node_rays(camera)
    off_axis_rad = float(np.arctan2(np.hypot(rays[..., 0], rays[..., 1]), rays[..., 2]).max())
    if off_axis_rad <= WIDEST_FLAT_RAD:
        plane = _between_nodes(columns, rows, rays[..., :2] / rays[..., 2:], camera)
        return Lens(camera.size_px, SAMPLES_A_SIDE, (flat_face(plane, SAMPLES_A_SIDE),))
    rays = _between_nodes(columns, rows, rays, camera)
    return Lens(camera.size_px, SAMPLES_A_SIDE, cube_faces(rays, SAMPLES_A_SIDE))


def check_lens(camera: Camera) -> None:
    """See that a lens can be simulated, without building it.

    Raises:
        InputError: It folds over inside the image.
    """
    if camera.model != "pinhole":
        _node_rays(camera)


def _node_rays(camera: Camera) -> tuple[Array, Array, Array]:
    """Return columns, rows and (rows, columns, 3) rays of every eighth pixel, and of the image's border."""
    columns, rows = (np.linspace(-0.5, n - 0.5, -(-n // _NODE_SPACING_PX) + 6) for n in camera.size_px)
    pixels = np.stack(np.meshgrid(columns, rows), -1)
    rays = camera.unproject(pixels.reshape(-1, 2)).reshape((*pixels.shape[:2], 3))
    dark = ~np.isfinite(rays).all(-1)
    if dark.any():
        from_center_px = np.linalg.norm(pixels[~dark] - np.array(camera.center_px), axis=1)
        raise InputError(
            f"a {camera.model} lens that folds over inside the image: distortion {list(camera.distortion)} "
            f"gives no ray beyond {from_center_px.max(initial=0.0):.0f} px from its centre; wanted a ray for "
            f"all of {camera.size_px[0]} x {camera.size_px[1]} pixels"
        )
    return columns, rows, rays


def _between_nodes(columns: Array, rows: Array, nodes: Array, camera: Camera) -> Array:
    """Return (2 H, 2 W, n) values at all samples; a quintic spline between the nodes is exact to 1e-5 px."""
    at_columns, at_rows = (
        (np.arange(SAMPLES_A_SIDE * n) + 0.5) / SAMPLES_A_SIDE - 0.5 for n in camera.size_px
    )
    splines = [
        RectBivariateSpline(rows, columns, nodes[..., axis], kx=5, ky=5) for axis in range(nodes.shape[-1])
    ]
    return np.stack([spline(at_rows, at_columns) for spline in splines], -1)
