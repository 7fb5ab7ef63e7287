"""Renderers behind one protocol: physics state in, one picture a camera out.

The classic renderer is MuJoCo's own OpenGL one, off-screen, with shadows and multisampling. It renders
pinholes only; lenses are made of its pictures in ``sim.sensing.lens``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from types import TracebackType
from typing import Protocol, Self

import mujoco
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from sim.rendering.culling import in_view
from sim.rendering.gl import no_gl_error, open_context
from sim.rendering.shadow_map import SharedShadowMap
from sim.vehicle.cameras import world_from_cam
from sim.vehicle.car import HIDDEN_GROUP

RgbImage = npt.NDArray[np.uint8]

MULTISAMPLES = 4
SHADOW_MAP_PX = 4096
SHADOW_RADIUS_M = 60.0  # of what the sun's shadow map covers
SHADOW_STRIDE_M = 20.0  # the map follows the car in strides: between them its texels stay where they are
SUN_DISTANCE_M = 150.0
NEAR_M, FAR_M = 0.05, 300.0
_MOST_GEOMS = 20_000


class Renderer(Protocol):
    """Turns the state of a world into pictures; a context manager, complete once constructed."""

    def render(self, data: mujoco.MjData) -> Mapping[str, RgbImage]:
        """Return each camera's (H, W, 3) picture of this instant; ``mj_forward`` was called on ``data``."""

    def __enter__(self) -> Self: ...

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None: ...


def write_visual_settings(spec: mujoco.MjSpec, sources: Mapping[str, Camera]) -> None:
    """Fix clip planes, buffer size and sampling; call once on the spec before it is compiled."""
    spec.stat.extent = 1.0  # MuJoCo scales the clip planes by this, which else follows the scene
    spec.visual.map.znear = NEAR_M
    spec.visual.map.zfar = FAR_M
    spec.visual.map.shadowclip = SHADOW_RADIUS_M
    spec.visual.quality.shadowsize = SHADOW_MAP_PX
    spec.visual.quality.offsamples = MULTISAMPLES
    spec.visual.global_.offwidth = max(source.size_px[0] for source in sources.values())
    spec.visual.global_.offheight = max(source.size_px[1] for source in sources.values())


class ClassicRenderer:
    """MuJoCo's OpenGL renderer for all cameras of a model, each at its own size."""

    def __init__(self, model: mujoco.MjModel, sources: Mapping[str, Camera]) -> None:
        """Take a model that holds one camera element a source, and make the OpenGL context.

        Raises:
            InputError: This machine cannot render; the line names the package to install.
        """
        self._model, self._sources = model, sources
        self._scene = mujoco.MjvScene(model, maxgeom=_MOST_GEOMS)
        self._option = mujoco.MjvOption()
        self._camera = mujoco.MjvCamera()
        self._camera.type = mujoco.mjtCamera.mjCAMERA_FIXED
        self._gl = open_context(model.vis.global_.offwidth, model.vis.global_.offheight)
        try:
            self._context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        except mujoco.FatalError as error:
            raise no_gl_error(error) from error
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)
        self._shadow_map = SharedShadowMap(self._context)

    def render(self, data: mujoco.MjData) -> dict[str, RgbImage]:
        self._gl.make_current()
        self._draw_shadow_map(data)
        with self._shadow_map.frozen():
            return {name: self._picture(data, name, source) for name, source in self._sources.items()}

    def _draw_shadow_map(self, data: mujoco.MjData) -> None:
        self._update_scene(data, next(iter(self._sources)))
        mujoco.mjr_render(mujoco.MjrRect(0, 0, 1, 1), self._scene, self._context)

    def _picture(self, data: mujoco.MjData, name: str, source: Camera) -> RgbImage:
        with _only(self._model, in_view(self._model, data, source, world_from_cam(data, name))):
            self._update_scene(data, name)
        width, height = source.size_px
        rect = mujoco.MjrRect(0, 0, width, height)
        mujoco.mjr_render(rect, self._scene, self._context)
        picture = np.empty((height, width, 3), np.uint8)
        mujoco.mjr_readPixels(picture, None, rect, self._context)
        return picture[::-1]  # OpenGL counts rows from the bottom

    def _update_scene(self, data: mujoco.MjData, name: str) -> None:
        self._camera.fixedcamid = self._model.camera(name).id
        everything = mujoco.mjtCatBit.mjCAT_ALL.value
        mujoco.mjv_updateScene(self._model, data, self._option, None, self._camera, everything, self._scene)
        middle = SHADOW_STRIDE_M * np.rint(data.cam_xpos.mean(0) / SHADOW_STRIDE_M) * [1, 1, 0]
        for light in self._scene.lights[: self._scene.nlight]:
            if light.castshadow and light.type == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL:
                light.pos = middle - SUN_DISTANCE_M * light.dir  # centres its shadow map

    def close(self) -> None:
        """Free the OpenGL objects; a renderer left to the interpreter's exit would raise there."""
        self._gl.make_current()
        self._context.free()
        self._gl.free()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


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
