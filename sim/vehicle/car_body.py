"""What is seen of the car: painted body, dark glass, wheels.

Every part is the convex hull of a few points on both sides, so a camera inside a hull looks out through it
(back faces are not drawn) and one outside sees it where a real one would.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from estimator.se3 import Array
from sim.vehicle.car_flank import DOORS_M, PAINT_RGBA, TRIM_RGBA, Rgba, flank_details

RIM_RGBA = (0.55, 0.55, 0.58, 1.0)
GLASS_RGBA = (0.13, 0.15, 0.17, 1.0)  # from outside it shows the sky more than the cabin

Profile = tuple[tuple[float, float, float], ...]
_MIRRORED = np.array([1.0, -1.0, 1.0])


@dataclass(frozen=True)
class Panel:
    """A convex part, mirrored about the car's middle: (x, half width, z) of its corners, in the ego frame."""

    name: str
    corners_m: Profile
    rgba: Rgba


# The bonnet falls away in front of the windscreen cameras: its front edge is 25 deg below the horizon there.
PANELS = (
    Panel(
        "bonnet",
        ((2.15, 0.80, 0.97), (3.30, 0.74, 0.77), (3.42, 0.70, 0.62), (3.42, 0.72, 0.28), (2.15, 0.84, 0.28)),
        PAINT_RGBA,
    ),
    Panel(
        "cabin",
        tuple((x, width - (0.0 if x > 0 else 0.012), z) for x in (2.16, -0.86) for z, width in DOORS_M),
        PAINT_RGBA,
    ),
    Panel(
        "windows",
        ((2.12, 0.79, 0.97), (1.42, 0.62, 1.45), (-0.35, 0.62, 1.45), (-0.82, 0.78, 0.97)),
        GLASS_RGBA,
    ),
    Panel(
        "roof",
        ((1.45, 0.63, 1.44), (1.20, 0.60, 1.51), (-0.20, 0.60, 1.51), (-0.40, 0.63, 1.43)),
        PAINT_RGBA,
    ),
    Panel(
        "bumper",
        ((-0.85, 0.80, 0.62), (-0.98, 0.72, 0.60), (-0.98, 0.72, 0.32), (-0.85, 0.80, 0.30)),
        TRIM_RGBA,
    ),
)


def write_body(spec: mujoco.MjSpec, chassis: mujoco.MjsBody) -> None:
    """Add the body's panels, and what is on its flanks, to the chassis."""
    for panel in PANELS:
        corners = np.array(panel.corners_m)
        _write_hull(spec, chassis, panel.name, np.concatenate([corners, corners * _MIRRORED]), panel.rgba)
    for detail in flank_details():
        _write_hull(spec, chassis, f"left_{detail.name}", detail.points_m, detail.rgba)
        _write_hull(spec, chassis, f"right_{detail.name}", detail.points_m * _MIRRORED, detail.rgba)


def _write_hull(
    spec: mujoco.MjSpec, chassis: mujoco.MjsBody, name: str, points_ego_m: Array, rgba: Rgba
) -> None:
    mesh = spec.add_mesh(name=f"car_{name}", uservert=points_ego_m.ravel())
    mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
    chassis.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=mesh.name, rgba=rgba, contype=0, conaffinity=0)


def write_wheel(rim: mujoco.MjsBody, wheel: str, radius_m: float) -> None:
    """Add tyre, rim and a spoke (which shows that it turns) to a wheel body."""
    outward = 1 if wheel.endswith("left") else -1
    across = [np.sqrt(0.5), np.sqrt(0.5), 0, 0]
    seen = {"contype": 0, "conaffinity": 0}
    cylinder = mujoco.mjtGeom.mjGEOM_CYLINDER
    rim.add_geom(type=cylinder, size=[radius_m, 0.1, 0], quat=across, rgba=TRIM_RGBA, **seen)
    rim.add_geom(
        type=cylinder, size=[0.2, 0.09, 0], pos=[0, 0.02 * outward, 0], quat=across, rgba=RIM_RGBA, **seen
    )
    rim.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=[0.03, 0.09, 0.17],
        pos=[0, 0.025 * outward, 0],
        rgba=TRIM_RGBA,
        **seen,
    )
