"""MuJoCo's own OpenGL renderer, off-screen, with shadows and multisampling."""

from __future__ import annotations

from collections.abc import Mapping

import mujoco
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import Array
from sim.rendering.canvas import Canvas
from sim.rendering.closing import Closing
from sim.rendering.shadow_map import SharedShadowMap
from sim.rendering.view import FAR_M, DepthImage, Picture, View

SHADOW_STRIDE_M = 20.0  # the map follows the car in strides: between them its texels stay where they are
SUN_DISTANCE_M = 150.0
SKY_SHARE = 0.694  # of the far plane: nowhere does MuJoCo draw the sky nearer (0.6952, over all directions)


class ClassicRenderer(Closing):
    """Draws any pinhole view of a model's state; ``sim.rendering.view.Renderer`` says how."""

    def __init__(self, model: mujoco.MjModel) -> None:
        """Make the OpenGL context, as large as the model's visual settings say.

        Raises:
            InputError: This machine cannot render; the line names the package to install.
        """
        self._model, self._canvas = model, Canvas(model)
        has_shadows = self._canvas.context.shadowSize > 0
        self._shadow_map = SharedShadowMap(self._canvas.context) if has_shadows else None
        self._middle_m: Array | None = None  # around which the shadow map was drawn

    def render(
        self, data: mujoco.MjData, views: Mapping[str, View], depth: bool = False, keep_shadows: bool = False
    ) -> dict[str, Picture]:
        self._canvas.make_current()
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
        self._canvas.gather(data)
        self._centre_shadow_map(middle_m)
        self._canvas.draw((1, 1), depth=False)

    def _picture(self, data: mujoco.MjData, view: View, middle_m: Array, depth: bool) -> Picture:
        self._canvas.gather_in(data, view)
        self._centre_shadow_map(middle_m)
        scene = self._canvas.scene
        for light in scene.lights[: scene.nlight]:
            if light.headlight:
                light.pos, light.dir = view.world_from_cam.translation, view.world_from_cam.rotation[:, 2]
        rgb, depth_m = self._canvas.draw(view.pinhole.size_px, depth)
        if depth_m is not None:
            depth_m[beyond_sky(depth_m, view.pinhole)] = FAR_M
        return Picture(rgb, depth_m)

    def _centre_shadow_map(self, middle_m: Array) -> None:
        centre = SHADOW_STRIDE_M * np.rint(middle_m / SHADOW_STRIDE_M) * [1, 1, 0]
        scene = self._canvas.scene
        for light in scene.lights[: scene.nlight]:
            if light.castshadow and light.type == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL:
                light.pos = centre - SUN_DISTANCE_M * light.dir

    def close(self) -> None:
        self._canvas.close()


def beyond_sky(depth_m: DepthImage, pinhole: Camera) -> npt.NDArray[np.bool_]:
    """Tell which (H, W) pixels show MuJoCo's sky, a dome at about 0.7 of the far plane."""
    (width, height), (fx, fy), (cx, cy) = pinhole.size_px, pinhole.focal_px, pinhole.center_px
    x, y = (
        ((np.arange(width) - cx) / fx).astype(np.float32),
        ((np.arange(height) - cy) / fy).astype(np.float32),
    )
    stretch2 = 1 + x[None, :] ** 2 + y[:, None] ** 2
    return np.asarray(depth_m * depth_m * stretch2 > np.float32((SKY_SHARE * FAR_M) ** 2))
