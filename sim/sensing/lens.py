"""Exact lens images: a finer pinhole image of the same view, resampled through the camera model.

A pinhole camera is rendered as it is. A distorted one is rendered by a source pinhole that covers its whole
field, finely enough for the sharpest place of the lens, then every pixel is the mean of a grid of samples at
the places where ``Camera.unproject`` says its rays meet the source plane.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt
from scipy.interpolate import RectBivariateSpline

from estimator.camera import Camera
from estimator.errors import InputError
from estimator.se3 import Array

GreyImage = npt.NDArray[np.float32]

SAMPLES_A_SIDE = 2  # per pixel: with the renderer's own multisampling enough against aliasing
SOURCE_DENSITY = 1.1  # source pixels per lens pixel at the sharpest place, so that nothing is lost to blur
_BORDER_PX = 2.0  # room for interpolation at the rim of the source
_NODE_SPACING_PX = 8
_WIDEST_RAD = np.radians(71.0)  # half angle that a source pinhole of sane size can serve


@dataclass(frozen=True, eq=False)
class Lens:
    """How one camera's image is made.

    Attributes:
        source: The pinhole to render.
        map_xy: (2 H, 2 W, 2) source pixel of each sample; None when the source is the camera itself.
    """

    source: Camera
    map_xy: npt.NDArray[np.float32] | None

    def apply(self, light: GreyImage) -> GreyImage:
        """Turn the source image into the camera's image; both are (rows, columns) of light."""
        if self.map_xy is None:
            return light
        samples = cv2.remap(light, self.map_xy, None, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
        height, width = (length // SAMPLES_A_SIDE for length in samples.shape)
        return np.asarray(cv2.resize(samples, (width, height), interpolation=cv2.INTER_AREA))


def make_lens(camera: Camera) -> Lens:
    """Build the lens of a camera; raises InputError if its field is too wide for a flat source."""
    if camera.model == "pinhole":
        return Lens(camera, None)
    plane = _sample_plane(camera)
    density_px = SOURCE_DENSITY * _sharpest_px(plane)
    low, high = plane.min((0, 1)), plane.max((0, 1))
    center_px = _BORDER_PX - low * density_px
    size_px = np.ceil((high - low) * density_px + 2 * _BORDER_PX).astype(int) + 1
    source = Camera(
        "pinhole",
        (int(size_px[0]), int(size_px[1])),
        (density_px, density_px),
        (float(center_px[0]), float(center_px[1])),
    )
    return Lens(source, (plane * density_px + center_px).astype(np.float32))


def _sample_plane(camera: Camera) -> Array:
    """Return (2 H, 2 W, 2): where the ray of each sample meets the plane at depth one.

    Only every eighth pixel is unprojected; a quintic spline between them is exact to 1e-5 px.
    """
    columns, rows = (np.linspace(-0.5, n - 0.5, -(-n // _NODE_SPACING_PX) + 6) for n in camera.size_px)
    rays = camera.unproject(np.stack(np.meshgrid(columns, rows), -1).reshape(-1, 2))
    _check_reach(camera, rays)
    nodes = (rays[:, :2] / rays[:, 2:]).reshape(len(rows), len(columns), 2)
    at_columns, at_rows = (
        (np.arange(SAMPLES_A_SIDE * n) + 0.5) / SAMPLES_A_SIDE - 0.5 for n in camera.size_px
    )
    splines = [RectBivariateSpline(rows, columns, nodes[..., axis], kx=5, ky=5) for axis in (0, 1)]
    return np.stack([spline(at_rows, at_columns) for spline in splines], -1)


def _check_reach(camera: Camera, rays: Array) -> None:
    off_axis_rad = np.arctan2(np.hypot(rays[:, 0], rays[:, 1]), rays[:, 2]).max()
    if not off_axis_rad <= _WIDEST_RAD:
        raise InputError(
            f"a {camera.model} camera sees {np.degrees(off_axis_rad):.0f} deg off its axis; "
            f"the classic renderer reaches {np.degrees(_WIDEST_RAD):.0f} deg"
        )


def _sharpest_px(plane: Array) -> float:
    """Return the lens's finest resolution, in lens pixels per unit of the plane at depth one."""
    across = np.linalg.norm(np.diff(plane, axis=1), axis=-1).min()
    down = np.linalg.norm(np.diff(plane, axis=0), axis=-1).min()
    return float(1 / (SAMPLES_A_SIDE * min(across, down)))
