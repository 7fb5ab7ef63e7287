"""Which geom each pixel shows and how far it is: drawn by MuJoCo with one sample a pixel, at its centre.

Beside the renderer of the images, whatever that is: multisampling would mix geoms, and its depth is that of
some other place in the pixel.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import mujoco
import numpy as np
import numpy.typing as npt

from sim.rendering.classic import MOST_GEOMS, aim, metres_of_z_buffer, only
from sim.rendering.closing import Closing
from sim.rendering.culling import in_view
from sim.rendering.gl import no_gl_error, open_context
from sim.rendering.view import DepthImage, View

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
        self._model = model
        self._scene = mujoco.MjvScene(model, maxgeom=MOST_GEOMS)
        self._scene.flags[mujoco.mjtRndFlag.mjRND_SEGMENT] = True
        self._scene.flags[mujoco.mjtRndFlag.mjRND_IDCOLOR] = True
        self._option, self._camera = mujoco.MjvOption(), mujoco.MjvCamera()
        self._gl = open_context(model.vis.global_.offwidth, model.vis.global_.offheight)
        try:
            self._context = _plain_context(model)
        except mujoco.FatalError as error:
            raise no_gl_error(error) from error
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)

    def render(self, data: mujoco.MjData, views: Mapping[str, View]) -> dict[str, GeomPicture]:
        """Return each view's picture of this instant; positions in ``data`` are up to date."""
        self._gl.make_current()
        return {name: self._picture(data, view) for name, view in views.items()}

    def _picture(self, data: mujoco.MjData, view: View) -> GeomPicture:
        everything = mujoco.mjtCatBit.mjCAT_ALL.value
        with only(self._model, in_view(self._model, data, view.pinhole, view.world_from_cam)):
            mujoco.mjv_updateScene(
                self._model, data, self._option, None, self._camera, everything, self._scene
            )
        for eye in self._scene.camera:
            aim(eye, view)
        width, height = view.pinhole.size_px
        rect = mujoco.MjrRect(0, 0, width, height)
        mujoco.mjr_render(rect, self._scene, self._context)
        rgb, z_buffer = np.empty((height, width, 3), np.uint8), np.empty((height, width), np.float32)
        mujoco.mjr_readPixels(rgb, z_buffer, rect, self._context)
        return GeomPicture(self._geoms(rgb[::-1]), metres_of_z_buffer(z_buffer[::-1]))

    def _geoms(self, rgb: npt.NDArray[np.uint8]) -> GeomImage:
        """Undo MuJoCo's colours: 24 bits that count the drawn geoms from 1."""
        drawn = rgb[..., 0] + 256 * rgb[..., 1].astype(np.int32) + 65536 * rgb[..., 2].astype(np.int32)
        geoms = np.full(self._scene.ngeom + 1, SKY, np.int32)
        for geom in self._scene.geoms[: self._scene.ngeom]:
            if geom.segid >= 0 and geom.objtype == mujoco.mjtObj.mjOBJ_GEOM.value:
                geoms[geom.segid + 1] = geom.objid
        return np.asarray(geoms[drawn])

    def close(self) -> None:
        """Free the OpenGL objects; a renderer left to the interpreter's exit would raise there."""
        self._gl.make_current()
        self._context.free()
        self._gl.free()


def _plain_context(model: mujoco.MjModel) -> mujoco.MjrContext:
    """Make a context without multisampling or shadow map, whatever the model's quality."""
    quality = model.vis.quality
    kept = quality.offsamples, quality.shadowsize
    quality.offsamples = quality.shadowsize = 0
    try:
        return mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
    finally:
        quality.offsamples, quality.shadowsize = kept
