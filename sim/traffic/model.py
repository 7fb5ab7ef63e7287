"""What an actor looks like: moving parts, each of one or more meshes in one or more skins."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import mujoco
import numpy as np

from estimator.se3 import Array
from sim.shapes.mesh import Mesh
from sim.streets.scenery import Skin, write_mesh, write_skin
from sim.traffic.pose import Stance, in_world

_PART = ".part"  # in a body's name, between the actor's and the part's number
Part = tuple[tuple[Mesh, str], ...]  # meshes and the names of their skins


@dataclass(frozen=True, eq=False)
class Model:
    """One kind of car, cyclist or pedestrian, to be used by many actors.

    Attributes:
        name: Unique.
        parts: In the order of the poses that its kind is given.
        skins: By name.
        length_m: What it takes up of a lane.
        axles_m: x of rear and front axle from its middle; of a pedestrian, heel and toe.
        wheel_m: Radius of its wheels.
        track_m: Between the middles of its left and right wheels.
        scale: Height over that of the average person.
    """

    name: str
    parts: tuple[Part, ...]
    skins: Mapping[str, Skin]
    length_m: float
    axles_m: tuple[float, float]
    wheel_m: float = 0.0
    track_m: float = 0.0
    scale: float = 1.0


class Bodies:
    """The bodies of some actors in a MuJoCo model, moved as a whole."""

    def __init__(self, prefix: str, models: list[Model]) -> None:
        """Take the name of the group and each actor's model; all have the same number of parts."""
        self._prefix, self._models = prefix, models
        self._ids: Array | None = None

    def write_into(self, spec: mujoco.MjSpec) -> None:
        """Add one mocap body a part; skins and meshes that another group wrote are used again."""
        for model in {model.name: model for model in self._models}.values():
            _write_model(spec, model)
        for number, model in enumerate(self._models):
            for part, pieces in enumerate(model.parts):
                body = spec.worldbody.add_body(
                    name=self._name(number, part), mocap=True, pos=[0.0, 0.0, -50.0]
                )
                for piece, (_, skin) in enumerate(pieces):
                    body.add_geom(
                        type=mujoco.mjtGeom.mjGEOM_MESH,
                        meshname=_mesh_name(model, part, piece),
                        material=f"skin_{skin}",
                        contype=0,
                        conaffinity=0,
                        mass=0.0,
                    )

    def place(self, data: mujoco.MjData, stance: Stance, parts: Array) -> None:
        """Move every part; ``parts`` is (N, K, 5) as in ``sim.traffic.pose``."""
        if not self._models:
            return
        if self._ids is None:
            names = [self._name(n, k) for n in range(len(self._models)) for k in range(parts.shape[1])]
            self._ids = np.array([int(data.model.body(name).mocapid[0]) for name in names])
        positions_m, quaternions = in_world(stance, parts)
        data.mocap_pos[self._ids] = positions_m.reshape(-1, 3)
        data.mocap_quat[self._ids] = quaternions.reshape(-1, 4)

    def _name(self, number: int, part: int) -> str:
        return f"{self._prefix}_{number}{_PART}{part}"


def actor_of(body: str) -> str:
    """Return the name of the actor that a body is a part of; of any other body, its own name."""
    return body.partition(_PART)[0]


def _write_model(spec: mujoco.MjSpec, model: Model) -> None:
    if spec.mesh(_mesh_name(model, 0, 0)) is not None:
        return
    for name, skin in model.skins.items():
        write_skin(spec, name, skin)
    for part, pieces in enumerate(model.parts):
        for piece, (mesh, _) in enumerate(pieces):
            write_mesh(spec, _mesh_name(model, part, piece), mesh)


def _mesh_name(model: Model, part: int, piece: int) -> str:
    return f"mesh_{model.name}_{part}_{piece}"
