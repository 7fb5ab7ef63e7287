"""Meshes of street furniture, each standing at the origin; what has a front faces +x. All share coats."""

from __future__ import annotations

import numpy as np

from sim.paint.furniture_parts import PLATE_M, REGIONS_M, SIGN_M, region
from sim.paint.tagged import cabinet_parts, lacquer, tagged_part
from sim.shapes.mesh import Mesh, Rect, box, disc, merged, quads, rect_uvs, tube

LAMP_HEAD_M = (1.55, 5.85)  # of a street lamp: how far before its foot, how high


def pole(height_m: float, radii_m: tuple[float, float] = (0.035, 0.035)) -> Mesh:
    """A steel pole; its radius below and above."""
    z = np.array([-0.3, 0.5 * height_m, height_m])
    radii = np.array([radii_m[0], *radii_m])
    return tube(np.column_stack([0 * z, 0 * z, z]), radii, 7, _along("steel", height_m, radii_m[0]))


def _along(name: str, length_m: float, radius_m: float) -> Rect:
    """A strip of a part as slender as what it is wound around, so that its spots are not drawn out."""
    u0, v0, u1, v1 = region(name)
    wide_m, tall_m = REGIONS_M[name][2:]
    half = (u1 - u0) * min(1.0, tall_m / length_m * 2 * np.pi * radius_m / wide_m) / 2
    return (u0 + u1) / 2 - half, v0, (u0 + u1) / 2 + half, v1


def lamp_post(height_m: float) -> Mesh:
    """A lamp on an arm that reaches towards +x."""
    z = np.array([-0.3, 0.9, 1.0, height_m])
    steel = _along("steel", height_m, 0.07)
    post = tube(np.column_stack([0 * z, 0 * z, z]), np.array([0.1, 0.1, 0.065, 0.05]), 8, steel)
    arm_x = np.array([0.0, 0.5, 1.4])
    arm_z = height_m + np.array([-0.05, 0.25, 0.35])
    arm = tube(np.column_stack([arm_x, 0 * arm_x, arm_z]), np.array([0.04, 0.035, 0.03]), 6, region("steel"))
    top = height_m + 0.27
    head = box((1.2, -0.12, top), (1.9, 0.12, top + 0.13), region("green"))
    glass = np.array([[(1.25, 0.1, top), (1.85, 0.1, top), (1.85, -0.1, top), (1.25, -0.1, top)]])
    return merged([post, arm, head, quads(glass, rect_uvs(region("lamp"))[None])])


def sign_post(faces: tuple[str, ...]) -> Mesh:
    """A pole with one or two signs, the first on top; they are read from +x."""
    top = 2.5 + 0.62 * (len(faces) - 1)
    parts = [pole(top + 0.2)]
    for k, name in enumerate(faces):
        parts += sign(name, top - 0.62 * k)
    return merged(parts)


def sign(name: str, z: float) -> list[Mesh]:
    """The face of a sign and its back, z high, just before a pole."""
    half, x = SIGN_M / 2, 0.045
    if name in ("limit", "no_parking", "stop", "no_entry"):
        front = disc((x, 0, z), half, 8 if name == "stop" else 20, region(name))
        back = disc((-x + 0.08, 0, -0.0), half, 20, region("back")).moved(yaw_rad=np.pi).moved((0.0, 0.0, z))
        return [front, back]
    wide, tall = (PLATE_M[0] / 2, PLATE_M[1] / 2) if name.startswith("plate") else (half, half)
    shape = {
        "warning": [(-1, -1), (1, -1), (0, 1), (0, 1)],
        "give_way": [(0, -1), (0, -1), (1, 1), (-1, 1)],
        "priority": [(-1, 0), (0, -1), (1, 0), (0, 1)],
    }.get(name, [(-1, -1), (1, -1), (1, 1), (-1, 1)])
    yz = np.array(shape, float)
    corners = np.column_stack([np.full(4, x), wide * yz[:, 0], z + tall * yz[:, 1]])[None]
    u0, v0, u1, v1 = region(name)
    uvs = np.column_stack([u0 + (u1 - u0) * (1 + yz[:, 0]) / 2, v0 + (v1 - v0) * (1 - yz[:, 1]) / 2])
    mirrored = corners[:, ::-1] - [0.02, 0, 0]
    return [quads(corners, uvs[None]), quads(mirrored, rect_uvs(region("back"))[None])]


def parking_meter() -> Mesh:
    """A machine for parking tickets on the pavement."""
    return merged(
        [
            box((-0.1, -0.12, 0.0), (0.1, 0.12, 0.9), region("steel")),
            box((-0.15, -0.17, 0.9), (0.15, 0.17, 1.65), region("meter"), region("steel")),
        ]
    )


def post_box() -> Mesh:
    """A box for letters on a post."""
    return merged(
        [
            box((-0.05, -0.05, 0.0), (0.05, 0.05, 0.7), region("steel")),
            box((-0.2, -0.26, 0.65), (0.2, 0.26, 1.4), region("post_box"), region("steel")),
        ]
    )


def bike_rack() -> Mesh:
    """Three hoops side by side along y."""
    parts = []
    for y in (-0.8, 0.0, 0.8):
        for x in (-0.25, 0.25):
            parts.append(box((x - 0.025, y - 0.025, 0.0), (x + 0.025, y + 0.025, 0.8), region("steel")))
        parts.append(box((-0.275, y - 0.025, 0.76), (0.275, y + 0.025, 0.81), region("steel")))
    return merged(parts)


def bollard() -> Mesh:
    """A striped post."""
    z = np.array([0.0, 0.9, 0.95])
    return tube(np.column_stack([0 * z, 0 * z, z]), np.array([0.07, 0.07, 0.001]), 8, region("stripes"))


def wheelie_bin() -> Mesh:
    """A household bin."""
    return merged(
        [
            box((-0.28, -0.26, 0.05), (0.28, 0.26, 0.98), region("bin"), region("steel")),
            box((-0.32, -0.29, 0.96), (0.34, 0.29, 1.06), region("green")),
        ]
    )


def litter_bin(index: int) -> Mesh:
    """A round bin on the pavement, with its own marks."""
    z = np.array([0.0, 0.1, 0.85, 0.9])
    return tube(
        np.column_stack([0 * z, 0 * z, z]), np.array([0.2, 0.22, 0.26, 0.02]), 10, tagged_part("bin", index)
    )


def cabinet(index: int) -> Mesh:
    """A switch cabinet with its own tags and stickers."""
    door, side = cabinet_parts(index)
    (x0, y0), (x1, y1), top = (-0.2, -0.55), (0.2, 0.55), 1.2
    walls = [((x1, y0), (x1, y1)), ((x1, y1), (x0, y1)), ((x0, y1), (x0, y0)), ((x0, y0), (x1, y0))]
    corners = np.array([[(*a, 0.0), (*b, 0.0), (*b, top), (*a, top)] for a, b in walls])
    roof = np.array([[(x0, y0, top), (x1, y0, top), (x1, y1, top), (x0, y1, top)]])
    parts = [rect_uvs(part) for part in (door, side, lacquer(), side)]
    return merged([quads(corners, np.array(parts)), quads(roof, rect_uvs(lacquer())[None])])


def advert_column(index: int) -> Mesh:
    """A round column covered with posters of its own."""
    z = np.array([0.0, 2.7])
    posters = tagged_part("column", index)
    body = tube(np.column_stack([0 * z, 0 * z, z]), np.array([0.55, 0.55]), 16, posters)
    z = np.array([2.7, 2.72, 2.9, 3.2])
    roof = tube(np.column_stack([0 * z, 0 * z, z]), np.array([0.56, 0.68, 0.6, 0.02]), 16, lacquer())
    return merged([body, roof])


def bench() -> Mesh:
    """A bench whose sitter looks towards +x."""
    wood, steel = region("wood"), region("steel")
    legs = [box((-0.2, y, 0), (0.2, y + 0.07, 0.4), steel) for y in (-0.7, 0.63)]
    back = box((-0.3, -0.8, 0.5), (-0.24, 0.8, 0.9), wood)
    return merged([*legs, box((-0.25, -0.8, 0.4), (0.25, 0.8, 0.47), wood), back])


def planter() -> Mesh:
    """A concrete trough for a bush."""
    return box((-0.45, -0.45, 0), (0.45, 0.45, 0.55), region("concrete"), region("wood"))
