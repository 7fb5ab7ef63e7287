"""A world as one GLB file, for any viewer, game engine or other renderer.

What is written is the compiled model at one instant: every drawn geom with its texture, under its own name,
with y up as glTF wants it. Lights and cameras are not written.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import trimesh
from PIL import Image

from sim.rendering.model_meshes import Surface, drawn_geoms, surface_of, texture_image, world_from_geom

_GLTF_FROM_WORLD = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])


def write_glb(model: mujoco.MjModel, data: mujoco.MjData, path: Path) -> None:
    """Write everything that is drawn, where ``data`` says it is; positions in ``data`` are up to date."""
    path.write_bytes(glb_scene(model, data).export(file_type="glb"))


def glb_scene(model: mujoco.MjModel, data: mujoco.MjData) -> trimesh.Scene:
    """Return a trimesh scene in glTF's axes; geoms that share a mesh and a skin share them there too."""
    scene, shapes = trimesh.Scene(), _Shapes(model)
    for geom in drawn_geoms(model):
        name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_GEOM, geom) or f"geom_{geom}"
        pose, key = _GLTF_FROM_WORLD @ world_from_geom(data, geom), shapes.key(geom)
        if key in scene.geometry:
            scene.graph.update(frame_to=name, matrix=pose, geometry=key)
        else:
            scene.add_geometry(shapes[geom], node_name=name, geom_name=key, transform=pose)
    return scene


class _Shapes:
    """Meshes by geom, made once for all geoms of the same mesh and material."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._made: dict[str, trimesh.Trimesh] = {}
        self._skins: dict[int, Any] = {}

    def key(self, geom: int) -> str:
        """Return what two geoms that look alike have in common."""
        model = self._model
        if model.geom_type[geom] != mujoco.mjtGeom.mjGEOM_MESH.value:
            return f"geom_{geom}"
        return (
            f"mesh_{model.geom_dataid[geom]}_{model.geom_matid[geom]}_{model.geom_rgba[geom].tobytes().hex()}"
        )

    def __getitem__(self, geom: int) -> trimesh.Trimesh:
        key = self.key(geom)
        if key not in self._made:
            surface = surface_of(self._model, geom)
            self._made[key] = trimesh.Trimesh(
                surface.vertices_geom,
                surface.faces,
                vertex_normals=surface.normals_geom,
                visual=self._visual(surface),
                process=False,
            )
        return self._made[key]

    def _visual(self, surface: Surface) -> Any:
        image = None if surface.texture is None else self._image(surface.texture)
        material = trimesh.visual.material.PBRMaterial(
            baseColorFactor=np.rint(255 * np.asarray(surface.rgba)).astype(np.uint8),
            baseColorTexture=image,
            metallicFactor=0.0,
            roughnessFactor=1.0,
        )
        uvs = None if surface.uvs is None else surface.uvs * [1, -1] + [0, 1]  # trimesh counts v upwards
        return trimesh.visual.TextureVisuals(uv=uvs, material=material)

    def _image(self, texture: int) -> Any:
        if texture not in self._skins:
            self._skins[texture] = Image.fromarray(texture_image(self._model, texture))
        return self._skins[texture]
