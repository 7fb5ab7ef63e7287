"""The independent second opinion: pyrender draws the model's triangles by its own code, on EGL.

What it shares with MuJoCo's renderers is the compiled model and the pose; projection, shading and shadows are
its own. Works beside a MuJoCo context in one process.
"""

from __future__ import annotations

from collections.abc import Mapping

import mujoco
import numpy as np
import pyrender
from OpenGL import EGL, GL
from pyrender.constants import RenderFlags

from estimator.se3 import SE3
from sim.rendering.closing import Closing
from sim.rendering.culling import in_view
from sim.rendering.pyrender_pipeline import OrderedPipeline
from sim.rendering.pyrender_programs import LightCounts
from sim.rendering.pyrender_scene import PyrenderScene
from sim.rendering.quality import sampling_of
from sim.rendering.sky_texture import sky_color, skybox_of
from sim.rendering.view import FAR_M, NEAR_M, Picture, RgbImage, View

_CAM_FROM_GLCAM = SE3(np.diag([1.0, -1.0, -1.0]))


class PyrenderRenderer(Closing):
    """Draws any pinhole view of a model's state; ``sim.rendering.view.Renderer`` says how."""

    def __init__(self, model: mujoco.MjModel) -> None:
        """Make the OpenGL context and read the model; textures and meshes may not change later."""
        self._model, self._sky = model, skybox_of(model)
        sampling = sampling_of(model)
        self._flags = RenderFlags.RGBA
        if sampling.shadow_map_px > 0:
            self._flags |= RenderFlags.SHADOWS_DIRECTIONAL
        self._world = PyrenderScene(model, sampling.shadow_map_px)
        width, height = int(model.vis.global_.offwidth), int(model.vis.global_.offheight)
        self._canvas = pyrender.OffscreenRenderer(width, height)
        lights = LightCounts.of(self._world.scene.light_nodes)
        self._pipeline = OrderedPipeline(width, height, sampling.multisamples, sampling.shadow_map_px, lights)
        self._canvas._renderer = self._pipeline
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)  # rows of textures follow each other without a gap

    def render(
        self, data: mujoco.MjData, views: Mapping[str, View], depth: bool = False, keep_shadows: bool = False
    ) -> dict[str, Picture]:
        middle_m = np.mean([view.world_from_cam.translation for view in views.values()], axis=0)
        self._world.update(data, middle_m)
        self._pipeline.everything = list(self._world.geom_nodes.values())
        self._pipeline.redraw_shadows |= not keep_shadows
        return {name: self._picture(data, view, depth) for name, view in views.items()}

    def _picture(self, data: mujoco.MjData, view: View, depth: bool) -> Picture:
        seen = in_view(self._model, data, view.pinhole, view.world_from_cam)
        self._pipeline.in_view = [node for geom, node in self._world.geom_nodes.items() if seen[geom]]
        self._pipeline.read_depth = depth
        self._aim(view)
        self._canvas.viewport_width, self._canvas.viewport_height = view.pinhole.size_px
        rgba, depth_m = self._canvas.render(self._world.scene, self._flags)
        return Picture(
            self._before_the_sky(rgba, view),
            np.where(depth_m > 0, depth_m, FAR_M).astype(np.float32) if depth else None,
        )

    def _aim(self, view: View) -> None:
        camera, pinhole = self._world.camera.camera, view.pinhole
        camera.fx, camera.fy = pinhole.focal_px
        camera.cx, camera.cy = (center_px + 0.5 for center_px in pinhole.center_px)  # counts from the corner
        camera.znear, camera.zfar = NEAR_M, FAR_M
        pose = view.world_from_cam @ _CAM_FROM_GLCAM
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = pose.rotation, pose.translation
        self._world.scene.set_pose(self._world.camera, matrix)

    def _before_the_sky(self, rgba: RgbImage, view: View) -> RgbImage:
        """Lay the picture over the sky; its colour is premultiplied by its opacity."""
        rows, columns = np.nonzero(rgba[..., 3] < 255)
        rgb = rgba[..., :3].copy()
        if self._sky is None or len(rows) == 0:
            return rgb
        rays_cam = view.pinhole.unproject(np.column_stack([columns, rows]).astype(float))
        sky = sky_color(self._sky, rays_cam @ view.world_from_cam.rotation.T)
        free = 1 - rgba[rows, columns, 3:] / 255
        mixed = np.rint(rgb[rows, columns] + free * sky)
        rgb[rows, columns] = np.minimum(mixed, 255).astype(np.uint8)
        return rgb

    def close(self) -> None:
        """Free the OpenGL objects; the display stays, for MuJoCo's contexts live on it too."""
        platform = self._canvas._platform
        platform.make_current()
        self._pipeline.delete()
        self._pipeline._shadow_fb = None  # or its number is freed again later, in another context
        nothing = EGL.EGL_NO_SURFACE
        EGL.eglMakeCurrent(platform._egl_display, nothing, nothing, EGL.EGL_NO_CONTEXT)
        EGL.eglDestroyContext(platform._egl_display, platform._egl_context)
        platform._egl_context = platform._egl_display = None
        self._canvas._platform = self._canvas._renderer = None
