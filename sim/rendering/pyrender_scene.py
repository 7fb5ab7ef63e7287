"""A MuJoCo model as a pyrender scene that follows the model's state."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np
import pyrender

from estimator.se3 import Array
from sim.rendering.linear_light import linear, sky_light
from sim.rendering.model_meshes import Surface, drawn_geoms, surface_of, texture_image, world_from_geom
from sim.rendering.pyrender_lights import PyrenderLights


class OrderedScene(pyrender.Scene):  # type: ignore[misc]
    """A scene whose lights come in a fixed order: the sum of their light depends on it in the last bit."""

    ordered_lights: tuple[Any, ...] = ()

    @property
    def light_nodes(self) -> tuple[Any, ...]:
        return self.ordered_lights


class PyrenderScene:
    """All drawn geoms and the lights of a model.

    Attributes:
        scene: What pyrender draws, with one camera.
        camera: The node of that camera.
        geom_nodes: Node by geom, in the order of the model.
    """

    def __init__(self, model: mujoco.MjModel, shadow_map_px: int) -> None:
        self._model = model
        self.scene = OrderedScene(bg_color=np.zeros(4), ambient_light=sky_light(model))
        textures = _Textures(model)
        self.geom_nodes: dict[int, Any] = {}
        for geom in drawn_geoms(model):
            mesh = _mesh(surface_of(model, geom), textures)
            self.geom_nodes[geom] = self.scene.add(mesh)
        self._lights = PyrenderLights(model, shadow_map_px)
        for node in self._lights.nodes.values():
            self.scene.add_node(node)
        self.scene.ordered_lights = tuple(self._lights.nodes.values())
        self.camera = self.scene.add(pyrender.IntrinsicsCamera(1.0, 1.0, 0.0, 0.0))
        self._drawn = np.array(list(self.geom_nodes))
        self._poses = np.full((len(self._drawn), 12), np.nan)

    def update(self, data: mujoco.MjData, middle_m: Array) -> None:
        """Follow the state; only what moved since the last call costs anything."""
        poses = np.hstack([data.geom_xpos[self._drawn], data.geom_xmat[self._drawn]])
        for row in np.flatnonzero((poses != self._poses).any(axis=1)):
            geom = int(self._drawn[row])
            self.scene.set_pose(self.geom_nodes[geom], world_from_geom(data, geom))
        self._poses = poses
        self._lights.update(data, middle_m)


class _Textures:
    """Textures by their index in the model, each made once."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._made: dict[int, Any] = {}

    def __getitem__(self, index: int) -> Any:
        if index not in self._made:
            self._made[index] = pyrender.Texture(
                source=texture_image(self._model, index), source_channels="RGB"
            )
        return self._made[index]


def _mesh(surface: Surface, textures: _Textures) -> Any:
    color = np.append(linear(surface.rgba[:3]), surface.rgba[3])
    material = pyrender.MetallicRoughnessMaterial(
        baseColorFactor=color,
        baseColorTexture=None if surface.texture is None else textures[surface.texture],
        # The shader squares it.
        emissiveFactor=np.sqrt(np.clip(surface.emission * color[:3], 0, 1)),
        metallicFactor=0.0,
        roughnessFactor=1.0,
        alphaMode="BLEND" if surface.rgba[3] < 1 else "OPAQUE",
    )
    primitive = pyrender.Primitive(
        positions=surface.vertices_geom,
        normals=surface.normals_geom,
        texcoord_0=None if surface.uvs is None else surface.uvs * [1, -1] + [0, 1],  # its v points up
        indices=surface.faces,
        material=material,
    )
    return pyrender.Mesh([primitive])
