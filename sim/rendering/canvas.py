"""Where MuJoCo draws: an off-screen OpenGL context with a model in it, aimed at one view after another."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import mujoco
import numpy as np
import numpy.typing as npt

from sim.rendering.closing import Closing
from sim.rendering.culling import in_view
from sim.rendering.frustum import frustum_of
from sim.rendering.gl import no_gl_error, open_context
from sim.rendering.view import FAR_M, NEAR_M, DepthImage, RgbImage, View
from sim.vehicle.car import HIDDEN_GROUP

_MOST_GEOMS = 20_000


class Canvas(Closing):
    """An OpenGL context as large and as fine as the model's visual settings say.

    First ``gather`` what is to be drawn, change lights of the ``scene`` if need be, then ``draw``.

    Attributes:
        scene: What was gathered.
        context: The model's meshes and textures in the driver.
    """

    def __init__(self, model: mujoco.MjModel) -> None:
        """Make the context and upload the model.

        Raises:
            InputError: This machine cannot render; the line names the package to install.
        """
        self._model = model
        self.scene = mujoco.MjvScene(model, maxgeom=_MOST_GEOMS)
        self._option, self._camera = mujoco.MjvOption(), mujoco.MjvCamera()
        self._gl = open_context(model.vis.global_.offwidth, model.vis.global_.offheight)
        try:
            self.context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        except mujoco.FatalError as error:
            raise no_gl_error(error) from error
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self.context)

    def make_current(self) -> None:
        """Take the driver over from whoever drew last; needed before anything else is called."""
        self._gl.make_current()

    def gather(self, data: mujoco.MjData) -> None:
        """Take in all geoms and lights of this instant."""
        everything = mujoco.mjtCatBit.mjCAT_ALL.value
        mujoco.mjv_updateScene(self._model, data, self._option, None, self._camera, everything, self.scene)

    def gather_in(self, data: mujoco.MjData, view: View) -> None:
        """Take in what a view may show, and aim at it; none of it casts a shadow."""
        with _only(self._model, in_view(self._model, data, view.pinhole, view.world_from_cam)):
            self.gather(data)
        for eye in self.scene.camera:
            _aim(eye, view)

    def draw(self, size_px: tuple[int, int], depth: bool) -> tuple[RgbImage, DepthImage | None]:
        """Return (H, W, 3) colours of what was gathered, and (H, W) metres along the axis if wanted."""
        width, height = size_px
        rect = mujoco.MjrRect(0, 0, width, height)
        mujoco.mjr_render(rect, self.scene, self.context)
        rgb = np.empty((height, width, 3), np.uint8)
        z_buffer = np.empty((height, width), np.float32) if depth else None
        mujoco.mjr_readPixels(rgb, z_buffer, rect, self.context)
        # OpenGL counts rows from the bottom.
        return rgb[::-1], None if z_buffer is None else _metres_of_z_buffer(z_buffer[::-1])

    def close(self) -> None:
        """Free the OpenGL objects; a context left to the interpreter's exit would raise there."""
        self._gl.make_current()
        self.context.free()
        self._gl.free()


@contextmanager
def _only(model: mujoco.MjModel, drawn: npt.NDArray[np.bool_]) -> Iterator[None]:
    """Hide all other geoms, and let none cast a shadow."""
    groups, casting = model.geom_group.copy(), model.geom_castshadow.copy()
    model.geom_group[~drawn] = HIDDEN_GROUP
    model.geom_castshadow[:] = 0
    try:
        yield
    finally:
        model.geom_group[:], model.geom_castshadow[:] = groups, casting


def _aim(eye: mujoco.MjvGLCamera, view: View) -> None:
    """Give MuJoCo's camera the pose and the frustum of a pinhole view."""
    pose, frustum = view.world_from_cam, frustum_of(view.pinhole)
    eye.pos = pose.translation
    eye.forward, eye.up = pose.rotation[:, 2], -pose.rotation[:, 1]
    eye.frustum_center, eye.frustum_width = frustum.center_m, frustum.half_width_m
    eye.frustum_bottom, eye.frustum_top = frustum.bottom_m, frustum.top_m
    eye.frustum_near, eye.frustum_far = NEAR_M, FAR_M


def _metres_of_z_buffer(z_buffer: DepthImage) -> DepthImage:
    """Undo the perspective depth of OpenGL: 0 at the near plane, 1 at the far one."""
    depth_m = NEAR_M * FAR_M / (FAR_M - z_buffer * np.float32(FAR_M - NEAR_M))
    return np.asarray(np.minimum(depth_m, FAR_M), np.float32)
