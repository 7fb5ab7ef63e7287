"""The independent second opinion: pyrender draws the model's triangles by its own code, on EGL.

What it shares with MuJoCo's renderers is the compiled model and the pose; projection, shading and shadows are
its own. Works beside a MuJoCo context in one process.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import mujoco
import numpy as np
import pyrender
from OpenGL import EGL, GL
from pyrender.constants import RenderFlags
from pyrender.renderer import Renderer as Pipeline

from estimator.se3 import SE3, Array
from sim.rendering.closing import Closing
from sim.rendering.culling import in_view
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
        self._pipeline = _OrderedPipeline(width, height, sampling.multisamples, sampling.shadow_map_px)
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


class _OrderedPipeline(Pipeline):  # type: ignore[misc]
    """pyrender's passes, but nodes in a fixed order, culled, and shadows once for all views of an instant.

    Attributes:
        everything: Nodes that cast shadows.
        in_view: Nodes that the next picture shows.
        redraw_shadows: Whether the next picture draws the shadow map first.
    """

    def __init__(self, width: int, height: int, multisamples: int, shadow_map_px: int) -> None:
        super().__init__(width, height)
        self._multisamples, self._shadow_map_px = multisamples, shadow_map_px
        self.everything: Sequence[Any] = ()
        self.in_view: Sequence[Any] = ()
        self.redraw_shadows = True
        self._casting = False

    def _shadow_mapping_pass(self, scene: Any, light_node: Any, flags: int) -> None:
        if self.redraw_shadows:
            self._casting = True
            super()._shadow_mapping_pass(scene, light_node, flags)
            self._casting = self.redraw_shadows = False

    def _sorted_mesh_nodes(self, scene: Any) -> list[Any]:
        nodes = self.everything if self._casting else self.in_view
        return sorted(nodes, key=lambda node: node.mesh.is_transparent)  # stable: the order of the model

    def _get_light_cam_matrices(self, scene: Any, light_node: Any, flags: int) -> tuple[Array, Array]:
        """Look from where the light's node stands, not from the edge of the whole scene."""
        camera = light_node.light._get_shadow_camera(0.0)
        return np.linalg.inv(light_node.matrix), camera.get_projection_matrix()

    def _configure_shadow_mapping_viewport(self, light: Any, flags: int) -> None:
        super()._configure_shadow_mapping_viewport(light, flags)
        GL.glViewport(0, 0, self._shadow_map_px, self._shadow_map_px)

    def _configure_main_framebuffer(self) -> None:
        is_new = self._main_fb is None or self._main_fb_dims != (self.viewport_width, self.viewport_height)
        super()._configure_main_framebuffer()
        if is_new:
            samples = min(self._multisamples, int(GL.glGetIntegerv(GL.GL_MAX_SAMPLES)))
            for buffer, kind in (
                (self._main_cb_ms, GL.GL_RGBA),
                (self._main_db_ms, GL.GL_DEPTH_COMPONENT24),
            ):
                GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, buffer)
                GL.glRenderbufferStorageMultisample(
                    GL.GL_RENDERBUFFER, samples, kind, self.viewport_width, self.viewport_height
                )
