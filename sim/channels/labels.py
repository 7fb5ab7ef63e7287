"""What each geom of a model is: its class, and the thing it is part of."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
import numpy.typing as npt

from sim.rendering.geom_picture import SKY, GeomImage
from sim.traffic.model import actor_of
from sim.vehicle.car import CHASSIS

CLASSES = (
    "sky",
    "road",
    "pavement",
    "land",
    "building",
    "vegetation",
    "furniture",
    "vehicle",
    "person",
    "cyclist",
    "own_car",
    "other",
)
# The first of these words in the name of a geom's body, or of its skin, says what it is.
_WORDS = {
    "pedestrian": "person",
    "cyclist": "cyclist",
    "car": "vehicle",
    "road": "road",
    "junction": "road",
    "pavement": "pavement",
    "kerb": "pavement",
    "land": "land",
    "house": "building",
    "wall": "building",
    "plain": "building",
    "tunnel": "building",
    "portal": "building",
    "plants": "vegetation",
    "furniture": "furniture",
    "sign": "furniture",
    "lamp": "furniture",
    "gantry": "furniture",
    "rail": "furniture",
    "marker": "furniture",
}


@dataclass(frozen=True, eq=False)
class Labels:
    """Class and instance by geom; the last entry of each array is the sky's.

    Attributes:
        class_of_geom: (ngeom + 1,) index into ``CLASSES``.
        instance_of_geom: (ngeom + 1,) 0 for the sky; all parts of a moving thing share one number.
        instance_names: Name by number.
    """

    class_of_geom: npt.NDArray[np.uint8]
    instance_of_geom: npt.NDArray[np.uint16]
    instance_names: tuple[str, ...]

    def classes(self, geom: GeomImage) -> npt.NDArray[np.uint8]:
        """Return the class of each pixel's geom."""
        return self.class_of_geom[geom]  # the sky's index, -1, is the last entry

    def instances(self, geom: GeomImage) -> npt.NDArray[np.uint16]:
        """Return the instance of each pixel's geom."""
        return self.instance_of_geom[geom]


assert SKY == -1  # what ``Labels`` relies on


def label_geoms(model: mujoco.MjModel) -> Labels:
    """Read classes and instances out of the names in a model."""
    names = ["sky"]
    numbers: dict[str, int] = {}
    classes, instances = np.zeros(model.ngeom + 1, np.uint8), np.zeros(model.ngeom + 1, np.uint16)
    for geom in range(model.ngeom):
        root = int(model.body_rootid[model.geom_bodyid[geom]])
        own_name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_GEOM, geom) or f"geom_{geom}"
        moving = root != 0
        name = actor_of(mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, root)) if moving else own_name
        if name not in numbers:
            numbers[name] = len(names)
            names.append(name)
        instances[geom] = numbers[name]
        classes[geom] = CLASSES.index(_class_of(model, geom, root, name))
    return Labels(classes, instances, tuple(names))


def _class_of(model: mujoco.MjModel, geom: int, root: int, name: str) -> str:
    if name == CHASSIS:
        return "own_car"
    if root != 0:
        return class_named(name)
    material = int(model.geom_matid[geom])
    skin = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_MATERIAL, material) if material >= 0 else ""
    return class_named(skin or "")


def class_named(name: str) -> str:
    """Return the class that the name of a skin or of a moving body tells."""
    return next((_WORDS[word] for word in name.split("_") if word in _WORDS), "other")
