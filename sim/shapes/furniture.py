"""Meshes of street furniture, each standing at the origin; what has a front faces +x. All share coats."""

from __future__ import annotations

import numpy as np

from sim.paint.furniture_parts import PLATE_M, SIGN_M, region
from sim.shapes.mesh import Mesh, box, disc, merged, quads, rect_uvs, tube

LAMP_HEAD_M = (1.55, 5.85)  # of a street lamp: how far before its foot, how high


def pole(height_m: float, radii_m: tuple[float, float] = (0.035, 0.035)) -> Mesh:
    """A steel pole; its radius below and above."""
    z = np.array([-0.3, 0.5 * height_m, height_m])
    radii = np.array([radii_m[0], *radii_m])
    return tube(np.column_stack([0 * z, 0 * z, z]), radii, 7, region("steel"))


def lamp_post(height_m: float) -> Mesh:
    """A lamp on an arm that reaches towards +x."""
    z = np.array([-0.3, 0.9, 1.0, height_m])
    post = tube(np.column_stack([0 * z, 0 * z, z]), np.array([0.1, 0.1, 0.065, 0.05]), 8, region("steel"))
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


def litter_bin() -> Mesh:
    """A round bin on the pavement."""
    z = np.array([0.0, 0.1, 0.85, 0.9])
    return tube(np.column_stack([0 * z, 0 * z, z]), np.array([0.2, 0.22, 0.26, 0.02]), 10, region("green"))


def cabinet() -> Mesh:
    """A switch cabinet with tags and stickers."""
    return box((-0.2, -0.55, 0.0), (0.2, 0.55, 1.2), region("cabinet"), region("steel"))


def advert_column() -> Mesh:
    """A round column covered with posters."""
    z = np.array([0.0, 2.7])
    body = tube(np.column_stack([0 * z, 0 * z, z]), np.array([0.55, 0.55]), 16, region("posters"))
    z = np.array([2.7, 2.72, 2.9, 3.2])
    roof = tube(np.column_stack([0 * z, 0 * z, z]), np.array([0.56, 0.68, 0.6, 0.02]), 16, region("green"))
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


def picket_fence(length_m: float) -> Mesh:
    """Pickets on two rails along +y from the origin."""
    wood = region("wood")
    u0, v0, u1, v1 = wood
    parts = []
    for k, y in enumerate(np.arange(0.0, length_m - 0.08, 0.16)):
        u = u0 + (u1 - u0) * ((k * 0.137) % 0.9)
        top = 1.0 + 0.05 * ((k * 7) % 3)
        parts.append(box((-0.015, y, 0.05), (0.015, y + 0.09, top), (u, v0, u + 0.1 * (u1 - u0), v1)))
    for z in (0.3, 0.8):
        parts.append(box((-0.04, 0, z), (0.04, length_m, z + 0.07), wood))
    return merged(parts)


def board_fence(length_m: float) -> Mesh:
    """A fence of upright boards, taller than a car, along y and centred on the origin."""
    u0, v0, u1, v1 = region("wood")
    parts = []
    for k, y in enumerate(np.arange(-length_m / 2, length_m / 2 - 0.2, 0.25)):
        u = u0 + (u1 - u0) * ((k * 0.37) % 0.85)
        top = 1.8 + 0.04 * ((k * 5) % 4)
        parts.append(box((-0.02, y, 0.0), (0.02, y + 0.235, top), (u, v0, u + 0.15 * (u1 - u0), v1)))
    return merged(parts)


def garden_wall(length_m: float, height_m: float = 0.8) -> Mesh:
    """A wall of concrete blocks along +y from the origin, every block its own piece of the texture."""
    u0, v0, u1, v1 = region("concrete")
    columns, rows = max(1, round(length_m / 1.1)), max(1, round(height_m / 0.6))
    y, z = np.linspace(0, length_m, columns + 1), np.linspace(0, height_m, rows + 1)
    parts = []
    for j in range(columns):
        for i in range(rows):
            left = u0 + 0.35 * (u1 - u0) * ((0.31 * j + 0.57 * i) % 1.0)
            part = (left, v0, left + 0.65 * (u1 - u0), v1)
            parts.append(box((-0.12, y[j], z[i]), (0.12, y[j + 1], z[i + 1]), part))
    return merged(parts)
