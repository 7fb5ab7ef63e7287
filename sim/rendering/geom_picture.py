"""Which geom each pixel shows and how far it is: drawn by MuJoCo with one sample a pixel, at its centre.

Beside the renderer of the images, whatever that is: multisampling would mix geoms, and its depth is that of
some other place in the pixel.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass

import mujoco
import numpy as np
import numpy.typing as npt

from sim.rendering.canvas import Canvas
from sim.rendering.closing import Closing
from sim.rendering.view import DepthImage, RgbImage, View

GeomImage = npt.NDArray[np.int32]
SKY = -1


@dataclass(frozen=True, eq=False)
class GeomPicture:
    """What a view shows.

    Attributes:
        geom: (H, W) index in the model, ``SKY`` where there is none.
        depth_m: (H, W) distance along the optical axis of the pixel's centre.
    """

    geom: GeomImage
    depth_m: DepthImage


class GeomRenderer(Closing):
    """Draws geoms instead of colours; a context manager, complete once constructed."""

    def __init__(self, model: mujoco.MjModel) -> None:
        """Make an OpenGL context of its own, as large as the model's visual settings say.

        Raises:
            InputError: This machine has no OpenGL; the line names the package to install.
        """
        with _one_sample_a_pixel(model):
            self._canvas = Canvas(model)
        self._canvas.scene.flags[mujoco.mjtRndFlag.mjRND_SEGMENT] = True
        self._canvas.scene.flags[mujoco.mjtRndFlag.mjRND_IDCOLOR] = True

    def render(self, data: mujoco.MjData, views: Mapping[str, View]) -> dict[str, GeomPicture]:
        """Return each view's picture of this instant; positions in ``data`` are up to date."""
        self._canvas.make_current()
        return {name: self._picture(data, view) for name, view in views.items()}

    def _picture(self, data: mujoco.MjData, view: View) -> GeomPicture:
        self._canvas.gather_in(data, view)
        rgb, depth_m = self._canvas.draw(view.pinhole.size_px, depth=True)
        assert depth_m is not None
        return GeomPicture(self._geoms(rgb), depth_m)

    def _geoms(self, rgb: RgbImage) -> GeomImage:
        """Undo MuJoCo's colours: 24 bits that count the drawn geoms from 1."""
        scene = self._canvas.scene
        drawn = rgb[..., 0] + 256 * rgb[..., 1].astype(np.int32) + 65536 * rgb[..., 2].astype(np.int32)
        geoms = np.full(scene.ngeom + 1, SKY, np.int32)
        for geom in scene.geoms[: scene.ngeom]:
            if geom.segid >= 0 and geom.objtype == mujoco.mjtObj.mjOBJ_GEOM.value:
                geoms[geom.segid + 1] = geom.objid
        return np.asarray(geoms[drawn])

    def close(self) -> None:
        self._canvas.close()


@contextmanager
def _one_sample_a_pixel(model: mujoco.MjModel) -> Iterator[None]:
    """Let contexts be made without multisampling or shadow map, whatever the model's quality."""
    quality = model.vis.quality
    kept = quality.offsamples, quality.shadowsize
    quality.offsamples = quality.shadowsize = 0
    try:
        yield
    finally:
        quality.offsamples, quality.shadowsize = kept
