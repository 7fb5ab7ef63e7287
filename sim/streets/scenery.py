"""What stands in a street: meshes, their skins and where they stand, and how these enter a MuJoCo spec.

The values know no renderer; only ``write_scenery`` touches MuJoCo.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
import numpy.typing as npt

from estimator.se3 import Array
from sim.paint.canvas import RgbImage
from sim.shapes.mesh import Mesh


@dataclass(frozen=True, eq=False)
class Skin:
    """A texture and how it shines.

    Attributes:
        image: (H, W, 3) uint8 RGB.
        specular: Strength of the highlight, 0 to 1.
        glow: (H, W) uint8 level of the light that it sheds by itself at night; None for none.
    """

    image: RgbImage
    specular: float = 0.0
    glow: npt.NDArray[np.uint8] | None = None


@dataclass(frozen=True, eq=False)
class Prop:
    """One thing in the scene.

    Attributes:
        name: Unique in the street.
        mesh: Its shape; props may share one.
        skin: Name of its skin.
        position_m: World position of the mesh's origin.
        yaw_rad: Turn about +z.
        footprint_m: (K, 2) convex outline on the ground in world xy, counter-clockwise, or None for what may
            overlap others (road, pavement, what hangs above the head).
    """

    name: str
    mesh: Mesh
    skin: str
    position_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    yaw_rad: float = 0.0
    footprint_m: Array | None = None


@dataclass(frozen=True, eq=False)
class Scenery:
    """Everything that stands around, and the skins it wears."""

    props: tuple[Prop, ...]
    skins: dict[str, Skin]

    def __add__(self, other: Scenery) -> Scenery:
        return Scenery(self.props + other.props, self.skins | other.skins)


NOTHING = Scenery((), {})


def write_scenery(spec: mujoco.MjSpec, scenery: Scenery) -> None:
    """Add textures, materials, meshes and geoms that nothing collides with."""
    for name, skin in scenery.skins.items():
        write_skin(spec, name, skin)
    mesh_names: dict[int, str] = {}
    for prop in scenery.props:
        key = id(prop.mesh)
        if key not in mesh_names:
            mesh_names[key] = f"mesh_{prop.name}"
            write_mesh(spec, mesh_names[key], prop.mesh)
        half = prop.yaw_rad / 2
        spec.worldbody.add_geom(
            name=f"scenery_{prop.name}",
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=mesh_names[key],
            material=f"skin_{prop.skin}",
            pos=prop.position_m,
            quat=[np.cos(half), 0.0, 0.0, np.sin(half)],
            contype=0,
            conaffinity=0,
            mass=0.0,
        )


def write_skin(spec: mujoco.MjSpec, name: str, skin: Skin) -> None:
    """Add a texture and the material ``skin_NAME`` that shows it."""
    height, width, channels = skin.image.shape
    texture = spec.add_texture(
        name=f"texture_{name}",
        type=mujoco.mjtTexture.mjTEXTURE_2D,
        width=width,
        height=height,
        nchannel=channels,
    )
    texture.data = np.ascontiguousarray(skin.image).tobytes()
    material = spec.add_material(name=f"skin_{name}", specular=skin.specular, shininess=0.6, reflectance=0.0)
    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = f"texture_{name}"


def write_mesh(spec: mujoco.MjSpec, name: str, mesh: Mesh) -> None:
    """Add a mesh under a name."""
    spec.add_mesh(
        name=name,
        uservert=mesh.vertices_m.ravel(),
        usernormal=mesh.normals.ravel(),
        usertexcoord=mesh.uvs.ravel(),
        userface=mesh.faces.ravel(),
        inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL,
    )
