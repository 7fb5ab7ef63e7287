"""The shapes, colours and textures of a compiled model, for renderers that are not MuJoCo's.

Everything that MuJoCo would draw is read out of the model itself, so no second description of the world can
differ. Compiling recentres and turns meshes: their vertices belong to the geom's pose in ``MjData``
(``geom_xpos``, ``geom_xmat``), never to ``geom_pos``.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
import numpy.typing as npt
import trimesh

from estimator.se3 import Array
from sim.rendering.view import RgbImage

_VISIBLE_GROUPS = 3  # MuJoCo draws groups 0 to 2 unless asked otherwise
_PLANE_REACH_M = 300.0  # of planes that never end
_ROUND_SECTIONS = 48


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles in a geom's own frame, and how they look.

    Attributes:
        vertices_geom: (N, 3).
        normals_geom: (N, 3) unit.
        uvs: (N, 2) with v down, or None.
        faces: (M, 3) corners, counter-clockwise seen from outside.
        rgba: Colour in display values; multiplies the texture.
        texture: Index of the model's texture, or None.
        emission: Glow as a share of the colour.
    """

    vertices_geom: Array
    normals_geom: Array
    uvs: Array | None
    faces: npt.NDArray[np.int64]
    rgba: Array
    texture: int | None
    emission: float


def drawn_geoms(model: mujoco.MjModel) -> list[int]:
    """Return the geoms that are drawn."""
    seen = (model.geom_group < _VISIBLE_GROUPS) & (model.geom_rgba[:, 3] > 0)
    return [int(geom) for geom in np.flatnonzero(seen)]


def surface_of(model: mujoco.MjModel, geom: int) -> Surface:
    """Return the surface of one geom."""
    material = int(model.geom_matid[geom])
    rgba, texture, emission = model.geom_rgba[geom], None, 0.0
    if material >= 0:
        own_color = not np.array_equal(rgba, [0.5, 0.5, 0.5, 1.0])  # the default gives way to the material's
        rgba = rgba if own_color else model.mat_rgba[material]
        found = int(model.mat_texid[material, mujoco.mjtTextureRole.mjTEXROLE_RGB.value])
        texture, emission = (found if found >= 0 else None), float(model.mat_emission[material])
    vertices, normals, uvs, faces = _triangles(model, geom)
    return Surface(vertices, normals, uvs, faces, rgba, None if uvs is None else texture, emission)


def texture_image(model: mujoco.MjModel, texture: int) -> RgbImage:
    """Return (H, W, 3) of a two-dimensional texture."""
    shape = [int(field[texture]) for field in (model.tex_height, model.tex_width, model.tex_nchannel)]
    first = int(model.tex_adr[texture])
    image = np.asarray(model.tex_data[first : first + int(np.prod(shape))]).reshape(shape)
    return np.ascontiguousarray(image[..., :3] if shape[2] >= 3 else np.repeat(image[..., :1], 3, axis=2))


def world_from_geom(data: mujoco.MjData, geom: int) -> Array:
    """Return the (4, 4) pose of a geom."""
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom]
    return pose


_Triangles = tuple[Array, Array, Array | None, npt.NDArray[np.int64]]


def _triangles(model: mujoco.MjModel, geom: int) -> _Triangles:
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH.value:
        return _mesh_triangles(model, int(model.geom_dataid[geom]))
    shape = _primitive(int(model.geom_type[geom]), model.geom_size[geom])
    corners = np.asarray(shape.vertices)[shape.faces.ravel()]
    smooth = model.geom_type[geom] in (
        mujoco.mjtGeom.mjGEOM_SPHERE.value,
        mujoco.mjtGeom.mjGEOM_ELLIPSOID.value,
    )
    normals = (
        np.asarray(shape.vertex_normals)[shape.faces.ravel()]
        if smooth
        else np.repeat(shape.face_normals, 3, axis=0)
    )
    return corners, normals, None, np.arange(len(corners)).reshape(-1, 3)


def _mesh_triangles(model: mujoco.MjModel, mesh: int) -> _Triangles:
    """Give each corner its own vertex: positions, normals and texture may be indexed differently."""
    faces = slice(model.mesh_faceadr[mesh], model.mesh_faceadr[mesh] + model.mesh_facenum[mesh])
    vertices = model.mesh_vert[model.mesh_vertadr[mesh] + model.mesh_face[faces].ravel()]
    normals = model.mesh_normal[model.mesh_normaladr[mesh] + model.mesh_facenormal[faces].ravel()]
    uvs = None
    if model.mesh_texcoordadr[mesh] >= 0:
        uvs = model.mesh_texcoord[model.mesh_texcoordadr[mesh] + model.mesh_facetexcoord[faces].ravel()]
    return vertices, normals, uvs, np.arange(len(vertices)).reshape(-1, 3)


def _primitive(kind: int, size: Array) -> trimesh.Trimesh:
    create, geom = trimesh.creation, mujoco.mjtGeom
    if kind == geom.mjGEOM_BOX.value:
        return create.box(2 * size)
    if kind == geom.mjGEOM_CYLINDER.value:
        return create.cylinder(size[0], 2 * size[1], sections=_ROUND_SECTIONS)
    if kind == geom.mjGEOM_CAPSULE.value:
        return create.capsule(2 * size[1], size[0], count=[_ROUND_SECTIONS, _ROUND_SECTIONS])
    if kind in (geom.mjGEOM_SPHERE.value, geom.mjGEOM_ELLIPSOID.value):
        ball = create.icosphere(subdivisions=4)
        ball.apply_scale(size if kind == geom.mjGEOM_ELLIPSOID.value else size[0])
        return ball
    if kind == geom.mjGEOM_PLANE.value:
        x, y = np.where(size[:2] > 0, size[:2], _PLANE_REACH_M)
        corners = [[-x, -y, 0], [x, -y, 0], [x, y, 0], [-x, y, 0]]
        return trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], process=False)
    raise ValueError(f"geom type {kind} has no mesh")
