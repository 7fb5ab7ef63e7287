"""MuJoCo's own OpenGL renderer, off-screen, with shadows and multisampling."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import mujoco
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import Array
from sim.rendering.closing import Closing
from sim.rendering.culling import in_view
from sim.rendering.frustum import frustum_of
from sim.rendering.gl import no_gl_error, open_context
from sim.rendering.shadow_map import SharedShadowMap
from sim.rendering.view import FAR_M, NEAR_M, DepthImage, Picture, View
from sim.vehicle.car import HIDDEN_GROUP

SHADOW_STRIDE_M = 20.0  # the map follows the car in strides: between them its texels stay where they are
SUN_DISTANCE_M = 150.0
SKY_SHARE = 0.694  # of the far plane: nowhere does MuJoCo draw the sky nearer (0.6952, over all directions)
MOST_GEOMS = 20_000


class ClassicRenderer(Closing):
    """Draws any pinhole view of a model's state; ``sim.rendering.view.Renderer`` says how."""

    def __init__(self, model: mujoco.MjModel) -> None:
        """Make the OpenGL context, as large as the model's visual settings say.

        Raises:
            InputError: This machine cannot render; the line names the package to install.
        """
        self._model = model
        self._scene = mujoco.MjvScene(model, maxgeom=MOST_GEOMS)
        self._option, self._camera = mujoco.MjvOption(), mujoco.MjvCamera()
        self._gl = open_context(model.vis.global_.offwidth, model.vis.global_.offheight)
        try:
            self._context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        except mujoco.FatalError as error:
            raise no_gl_error(error) from error
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)
        has_shadows = self._context.shadowSize > 0
        self._shadow_map = SharedShadowMap(self._context) if has_shadows else None
        self._middle_m: Array | None = None  # around which the shadow map was drawn

    def render(
        self, data: mujoco.MjData, views: Mapping[str, View], depth: bool = False, keep_shadows: bool = False
    ) -> dict[str, Picture]:
        self._gl.make_current()
        if self._middle_m is None or not keep_shadows:
            self._middle_m = np.mean([view.world_from_cam.translation for view in views.values()], axis=0)
        if self._shadow_map is None or not self._has_sun():
            return self._pictures(data, views, self._middle_m, depth)
        if not keep_shadows:
            self._draw_shadow_map(data, self._middle_m)
        with self._shadow_map.frozen():
            return self._pictures(data, views, self._middle_m, depth)

    def _has_sun(self) -> bool:
        return bool((self._model.light_castshadow.astype(bool) & self._model.light_active.astype(bool)).any())

    def _pictures(
        self, data: mujoco.MjData, views: Mapping[str, View], middle_m: Array, depth: bool
    ) -> dict[str, Picture]:
        return {name: self._picture(data, view, middle_m, depth) for name, view in views.items()}

    def _draw_shadow_map(self, data: mujoco.MjData, middle_m: Array) -> None:
        self._update_scene(data, middle_m)
        mujoco.mjr_render(mujoco.MjrRect(0, 0, 1, 1), self._scene, self._context)

    def _picture(self, data: mujoco.MjData, view: View, middle_m: Array, depth: bool) -> Picture:
        with only(self._model, in_view(self._model, data, view.pinhole, view.world_from_cam)):
            self._update_scene(data, middle_m)
        for eye in self._scene.camera:
            aim(eye, view)
        for light in self._scene.lights[: self._scene.nlight]:
            if light.headlight:
                light.pos, light.dir = view.world_from_cam.translation, view.world_from_cam.rotation[:, 2]
        width, height = view.pinhole.size_px
        rect = mujoco.MjrRect(0, 0, width, height)
        mujoco.mjr_render(rect, self._scene, self._context)
        rgb = np.empty((height, width, 3), np.uint8)
        z_buffer = np.empty((height, width), np.float32) if depth else None
        mujoco.mjr_readPixels(rgb, z_buffer, rect, self._context)
        # OpenGL counts rows from the bottom.
        depth_m = None if z_buffer is None else metres_of_z_buffer(z_buffer[::-1])
        if depth_m is not None:
            depth_m[beyond_sky(depth_m, view.pinhole)] = FAR_M
        return Picture(rgb[::-1], depth_m)

    def _update_scene(self, data: mujoco.MjData, middle_m: Array) -> None:
        everything = mujoco.mjtCatBit.mjCAT_ALL.value
        mujoco.mjv_updateScene(self._model, data, self._option, None, self._camera, everything, self._scene)
        centre = SHADOW_STRIDE_M * np.rint(middle_m / SHADOW_STRIDE_M) * [1, 1, 0]
        for light in self._scene.lights[: self._scene.nlight]:
            if light.castshadow and light.type == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL:
                light.pos = centre - SUN_DISTANCE_M * light.dir  # centres its shadow map

    def close(self) -> None:
        """Free the OpenGL objects; a renderer left to the interpreter's exit would raise there."""
        self._gl.make_current()
        self._context.free()
        self._gl.free()


@contextmanager
def only(model: mujoco.MjModel, drawn: npt.NDArray[np.bool_]) -> Iterator[None]:
    """Hide all other geoms, and let none cast a shadow."""
    groups, casting = model.geom_group.copy(), model.geom_castshadow.copy()
    model.geom_group[~drawn] = HIDDEN_GROUP
    model.geom_castshadow[:] = 0
    try:
        yield
    finally:
        model.geom_group[:], model.geom_castshadow[:] = groups, casting


def aim(eye: mujoco.MjvGLCamera, view: View) -> None:
    """Give MuJoCo's camera the pose and the frustum of a pinhole view."""
    pose, frustum = view.world_from_cam, frustum_of(view.pinhole)
    eye.pos = pose.translation
    eye.forward, eye.up = pose.rotation[:, 2], -pose.rotation[:, 1]
    eye.frustum_center, eye.frustum_width = frustum.center_m, frustum.half_width_m
    eye.frustum_bottom, eye.frustum_top = frustum.bottom_m, frustum.top_m
    eye.frustum_near, eye.frustum_far = NEAR_M, FAR_M


def beyond_sky(depth_m: DepthImage, pinhole: Camera) -> npt.NDArray[np.bool_]:
    """Tell which (H, W) pixels show MuJoCo's sky, a dome at about 0.7 of the far plane."""
    (width, height), (fx, fy), (cx, cy) = pinhole.size_px, pinhole.focal_px, pinhole.center_px
    x, y = (
        ((np.arange(width) - cx) / fx).astype(np.float32),
        ((np.arange(height) - cy) / fy).astype(np.float32),
    )
    stretch2 = 1 + x[None, :] ** 2 + y[:, None] ** 2
    return np.asarray(depth_m * depth_m * stretch2 > np.float32((SKY_SHARE * FAR_M) ** 2))


def metres_of_z_buffer(z_buffer: DepthImage) -> DepthImage:
    """Undo the perspective depth of OpenGL: 0 at the near plane, 1 at the far one."""
    depth_m = NEAR_M * FAR_M / (FAR_M - z_buffer * np.float32(FAR_M - NEAR_M))
    return np.asarray(np.minimum(depth_m, FAR_M), np.float32)
