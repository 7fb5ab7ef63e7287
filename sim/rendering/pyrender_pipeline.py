"""pyrender's passes with less work for the same pixels: culled, shadows once, nothing set twice."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from OpenGL import GL
from pyrender.constants import RenderFlags
from pyrender.renderer import Renderer as Pipeline

from estimator.se3 import Array
from sim.rendering.pyrender_programs import LightCounts, ThriftyPrograms


class OrderedPipeline(Pipeline):  # type: ignore[misc]
    """pyrender's passes, but nodes in a fixed order, culled, and shadows once for all views of an instant.

    Attributes:
        everything: Nodes that cast shadows.
        in_view: Nodes that the next picture shows.
        redraw_shadows: Whether the next picture draws the shadow map first.
        read_depth: Whether the next picture's depth is wanted; else there is none.
    """

    def __init__(
        self, width: int, height: int, multisamples: int, shadow_map_px: int, lights: LightCounts
    ) -> None:
        super().__init__(width, height)
        self._multisamples, self._shadow_map_px, self._lights = multisamples, shadow_map_px, lights
        self._program_cache = ThriftyPrograms(lights)
        self._program_of: dict[tuple[Any, int, int], Any] = {}
        self._lit: set[Any] = set()
        self.everything: Sequence[Any] = ()
        self.in_view: Sequence[Any] = ()
        self.redraw_shadows = self.read_depth = True
        self._casting = False

    def _shadow_mapping_pass(self, scene: Any, light_node: Any, flags: int) -> None:
        if self.redraw_shadows:
            self._casting = True
            super()._shadow_mapping_pass(scene, light_node, flags)
            self._casting = self.redraw_shadows = False

    def _forward_pass(self, scene: Any, flags: int, seg_node_map: Any = None) -> Any:
        self._lit.clear()
        return super()._forward_pass(scene, flags, seg_node_map)

    def _sorted_mesh_nodes(self, scene: Any) -> list[Any]:
        nodes = self.everything if self._casting else self.in_view
        return sorted(nodes, key=lambda node: node.mesh.is_transparent)  # stable: the order of the model

    def _get_primitive_program(self, primitive: Any, flags: int, program_flags: int) -> Any:
        key = (primitive, flags, program_flags)
        if key not in self._program_of:
            self._program_of[key] = super()._get_primitive_program(*key)
        return self._program_of[key]

    def _compute_max_n_lights(self, flags: int) -> list[int]:
        """As many as there are: software runs the shadows of every light there might be."""
        return [max(count, 1) for count in self._lights[:3]]

    def _bind_lighting(self, scene: Any, program: Any, node: Any, flags: int) -> None:
        """Tell each program of the lights once a picture, unless each node has its own nearest ones."""
        if program in self._lit and not self._lights.are_chosen_by_node:
            has_shadows = bool(flags & RenderFlags.SHADOWS_DIRECTIONAL)
            self._texture_alloc_idx = self._lights.directional if has_shadows else 0  # theirs stay bound
            return
        super()._bind_lighting(scene, program, node, flags)
        self._lit.add(program)

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

    def _read_main_framebuffer(self, scene: Any, flags: int) -> tuple[npt.NDArray[np.uint8], Any]:
        """Leave the depth where it is unless it is wanted."""
        if self.read_depth:
            color, depth_m = super()._read_main_framebuffer(scene, flags)
            return color, depth_m
        width, height = self._main_fb_dims
        GL.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, self._main_fb_ms)
        GL.glBindFramebuffer(GL.GL_DRAW_FRAMEBUFFER, self._main_fb)
        corners = (0, 0, width, height)
        GL.glBlitFramebuffer(*corners, *corners, GL.GL_COLOR_BUFFER_BIT, GL.GL_NEAREST)
        GL.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, self._main_fb)
        pixels = GL.glReadPixels(0, 0, width, height, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE)
        return np.flip(np.frombuffer(pixels, np.uint8).reshape(height, width, 4), axis=0), None
