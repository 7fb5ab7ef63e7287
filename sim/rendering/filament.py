"""MuJoCo's physically based renderer (Filament on Vulkan): soft shadows, light from the whole sky, occlusion.

It lives in one context of its own, made anew for every renderer: its dithering draws from a generator that
starts with the context, so the same drive gives the same bytes whatever was rendered before. A broken Vulkan
driver ends the process, so ``sim.rendering.choice`` tries it elsewhere first.
"""

from __future__ import annotations

import copy
import gc
from collections.abc import Mapping
from importlib import import_module
from typing import Any

import cv2
import mujoco
import numpy as np

from sim.rendering.closing import Closing
from sim.rendering.filament_light import FilamentLights
from sim.rendering.frustum import frustum_of
from sim.rendering.quality import sampling_of
from sim.rendering.quiet import quiet_output
from sim.rendering.view import FAR_M, NEAR_M, DepthImage, Picture, RgbImage, View

_SRGB = 2  # mjCOLORSPACE_SRGB: textures else count as linear, and all looks pale


class FilamentRenderer(Closing):
    """Draws any pinhole view of a model's state; ``sim.rendering.view.Renderer`` says how."""

    def __init__(self, model: mujoco.MjModel) -> None:
        """Make the context and upload the model; lights may change later, meshes and textures may not."""
        import_module("mujoco.studio.window")  # registers the materials, which are not found otherwise
        self._mjrf = mjrf = import_module("mujoco.mjrf")
        self._sampling = sampling_of(model)
        with quiet_output():
            api = mjrf.GraphicsApi.GRAPHICS_API_VULKAN
            self._context = mjrf.Context(mjrf.ContextConfig(graphics_api=api))
            self._context.set_clear_color(np.zeros(3, np.float32))
            colored = _with_srgb_textures(model)
            resources = mjrf.ModelResources(self._context, colored)
            self._scene = self._context.create_scene(mjrf.SceneParams())
            self._scene.configure_from_model(colored)
            self._lights = FilamentLights(mjrf, self._context, self._scene, model, self._shadow_map_px)
            self._renderables = mjrf.ModelRenderables(self._scene, resources)
            self._put_in_order(model.ngeom)
            self._targets: dict[tuple[int, int, bool], tuple[Any, Any, Any]] = {}

    @property
    def _shadow_map_px(self) -> int:
        return self._sampling.shadow_map_px

    def render(
        self, data: mujoco.MjData, views: Mapping[str, View], depth: bool = False, keep_shadows: bool = False
    ) -> dict[str, Picture]:
        self._lights.update(data)
        self._renderables.update(data)
        return {
            name: Picture(self._rgb(view), self._depth_m(view) if depth else None)
            for name, view in views.items()
        }

    def _put_in_order(self, geom_count: int) -> None:
        """Add every geom to the scene again, in turn, each with its material's instance made anew.

        The order in which they come first differs from context to context, and where roofs go through each
        other and tie in depth, it decides what is seen: a handful of pixels, by a few levels.
        """
        geom = mujoco.mjtObj.mjOBJ_GEOM
        drawn = [self._renderables.get_renderable(geom, number) for number in range(geom_count)]
        drawn = [renderable for renderable in drawn if renderable is not None]
        for renderable in drawn:
            self._scene.remove_renderable(renderable)
        for renderable in drawn:
            self._scene.add_renderable(renderable)
            renderable.set_material(renderable.get_material())

    def _rgb(self, view: View) -> RgbImage:
        finer = self._sampling.supersamples
        pixels = self._draw(view, finer, False)
        if finer == 1:
            return np.array(pixels)
        return np.asarray(cv2.resize(pixels, view.pinhole.size_px, interpolation=cv2.INTER_AREA))

    def _depth_m(self, view: View) -> DepthImage:
        """Undo the reversed depth: 1 at the near plane, 0 at the far one."""
        reversed_z = self._draw(view, 1, True)
        return np.asarray(NEAR_M * FAR_M / (reversed_z * np.float32(FAR_M - NEAR_M) + np.float32(NEAR_M)))

    def _draw(self, view: View, finer: int, depth: bool) -> Any:
        mjrf = self._mjrf
        width, height = (finer * length for length in view.pinhole.size_px)
        target, read, pixels = self._target(width, height, depth)
        request = mjrf.RenderRequest(scene=self._scene, target=target, camera=self._camera(view))
        request.viewport.width, request.viewport.height = width, height
        request.shadows = not depth and self._shadow_map_px > 0
        if depth:
            request.draw_mode = mjrf.DrawMode.DRAW_MODE_DEPTH
            request.post_processing = request.skybox = False
        self._context.wait_for_frame(self._context.render([request], [read]))
        return pixels

    def _camera(self, view: View) -> Any:
        pose, frustum = view.world_from_cam, frustum_of(view.pinhole)
        return self._mjrf.Camera(
            pos=pose.translation.astype(np.float32),
            forward=pose.rotation[:, 2].astype(np.float32),
            up=-pose.rotation[:, 1].astype(np.float32),
            frustum_center=frustum.center_m,
            frustum_width=frustum.half_width_m,
            frustum_bottom=frustum.bottom_m,
            frustum_top=frustum.top_m,
            frustum_near=NEAR_M,
            frustum_far=FAR_M,
        )

    def _target(self, width: int, height: int, depth: bool) -> tuple[Any, Any, Any]:
        """Return (render target, read request, pixels) of a size, kept for the next picture like it."""
        key = (width, height, depth)
        if key not in self._targets:
            formats = self._mjrf.PixelFormat
            pixel_format = formats.PIXEL_FORMAT_R32F if depth else formats.PIXEL_FORMAT_RGB8
            target = self._context.create_render_target(
                self._mjrf.RenderTargetConfig(color_format=pixel_format)
            )
            target.resize(width, height)
            pixels = np.zeros(
                (height, width) if depth else (height, width, 3), np.float32 if depth else np.uint8
            )
            read = self._mjrf.ReadRequest(target=target)
            read.set_buffer(pixels)
            self._targets[key] = (target, read, pixels)
        return self._targets[key]

    def close(self) -> None:
        """Free what the context made, then the context."""
        with quiet_output():
            self._targets.clear()
            del self._renderables, self._lights, self._scene
            del self._context
            gc.collect()


def _with_srgb_textures(model: mujoco.MjModel) -> mujoco.MjModel:
    """Return a copy whose textures hold display values, as its plain colours do."""
    colored = copy.copy(model)
    colored.tex_colorspace[:] = _SRGB
    return colored
