"""Islands in the carriageway: the middle of a roundabout, the strips between the bays of a car park."""

from __future__ import annotations

import numpy as np
from shapely.geometry import LineString, Polygon

from estimator.se3 import Array
from sim.shapes.car_park import shelter, ticket_machine, trolleys
from sim.shapes.furniture import lamp_post, sign_post
from sim.streets.catalogue import furniture_skin
from sim.streets.kerb import KerbLine
from sim.streets.lamps import Lamp
from sim.streets.network import Network
from sim.streets.placing import Site, Thing
from sim.streets.planting import Greenery

_THIN_M = 3.0
_MAST_M = 7.5
_TREE_EVERY_M, _MAST_EVERY_M = 8.0, 16.0
_FINE_TREES_M = 14.0  # from the driven line; nothing stands before them as it does along a street


def furnish_islands(site: Site, network: Network, green: Greenery) -> list[Lamp]:
    """Plant and light every island; a strip also carries what a car park needs."""
    lamps: list[Lamp] = []
    strips = 0
    for kerb in network.kerbs:
        if kerb.lining != "island" or not kerb.path.closed:
            continue
        outline = Polygon(kerb.path.points_m)
        axis = _long_axis(outline)
        if outline.area / axis.length < _THIN_M:
            lamps += _strip(site, kerb, axis, strips, green)
            strips += 1
        else:
            _round(site, kerb, outline, green)
    return lamps


def _long_axis(outline: Polygon) -> LineString:
    """The line along the middle of an outline, from end to end."""
    corners = np.asarray(outline.minimum_rotated_rectangle.exterior.coords)
    sides = np.linalg.norm(np.diff(corners[:3], axis=0), axis=1)
    a, b, c, d = corners[:4] if sides[0] >= sides[1] else corners[1:5]
    return LineString([(a + d) / 2, (b + c) / 2])


def _strip(site: Site, kerb: KerbLine, axis: LineString, index: int, green: Greenery) -> list[Lamp]:
    """Trees and masts in turn; one strip has the ticket machine, the next one the trolleys."""
    (start, end), rng = np.asarray(axis.coords), green.rng
    ahead = (end - start) / axis.length
    yaw = float(np.arctan2(ahead[1], ahead[0]))
    lamps = []
    for s in np.arange(_MAST_EVERY_M / 2 - 3.0, axis.length - 1.0, _MAST_EVERY_M):
        at = start + s * ahead
        for turn in (np.pi / 2, -np.pi / 2):
            lamps.append(_mast_lamp(site, at, yaw + turn, kerb))
        mast = Thing(lamp_post(_MAST_M), furniture_skin(0), (0.3, 0.3))
        site.put_at(mast, at, yaw + np.pi / 2, kerb.height_m)
    if index == 0:
        machine = Thing(ticket_machine(), furniture_skin(1), (0.6, 0.7))
        site.put_at(machine, start + 1.6 * ahead, yaw, kerb.height_m)
    else:
        roof = Thing(shelter(), furniture_skin(index % 3), (3.6, 1.2))
        if site.put_at(roof, start + 0.5 * axis.length * ahead, yaw, kerb.height_m):
            site.put_at(
                Thing(trolleys(), furniture_skin(2), (0.0, 0.0)),
                start + 0.5 * axis.length * ahead,
                yaw,
                kerb.height_m,
            )
    for s in np.arange(2.5, axis.length - 1.0, _TREE_EVERY_M):
        far_tree = green.catalogue.trees[int(rng.integers(len(green.catalogue.trees)))]
        fine = site.from_route_m(start + s * ahead) < _FINE_TREES_M
        tree = next(green.catalogue.street_trees) if fine else far_tree
        site.put_at(tree, start + s * ahead, rng.uniform(0, 6), kerb.height_m, 0.3, shown=green.grows())
    for s in np.arange(1.0, axis.length - 0.5, 1.3):
        bush = green.catalogue.bushes[int(rng.integers(len(green.catalogue.bushes)))]
        if rng.random() < 0.5:
            site.put_at(bush, start + s * ahead, rng.uniform(0, 6), kerb.height_m, shown=green.grows())
    return lamps


def _mast_lamp(site: Site, at: Array, yaw: float, kerb: KerbLine) -> Lamp:
    x, y = at + 1.55 * np.array([np.cos(yaw), np.sin(yaw)])
    z = float(site.relief.height_m(at)) + kerb.height_m + _MAST_M + 0.25
    return Lamp((float(x), float(y), z), (0.0, 0.0, -1.0), "mast")


def _round(site: Site, kerb: KerbLine, outline: Polygon, green: Greenery) -> None:
    """Chevrons towards whoever enters, a tree in the middle, bushes around it."""
    rng, middle = green.rng, np.asarray(outline.centroid.coords[0])
    radius = float(np.sqrt(outline.area / np.pi))
    chevron = Thing(sign_post(("chevron",)), furniture_skin(0), (0.1, 0.62))
    for angle in np.arange(0.4, 2 * np.pi, 2 * np.pi / 5):
        out = np.array([np.cos(angle), np.sin(angle)])
        site.put_at(chevron, middle + (radius - 0.9) * out, float(angle), kerb.height_m)
    site.put_at(next(green.catalogue.street_trees), middle, 0.0, kerb.height_m, shown=green.grows())
    for k in range(round(2.2 * radius**2)):
        angle, share = 2.39996 * k, np.sqrt((k + 1.0) / (2.2 * radius**2))
        at = middle + (radius - 1.4) * share * np.array([np.cos(angle), np.sin(angle)])
        bush = green.catalogue.bushes[int(rng.integers(len(green.catalogue.bushes)))]
        if rng.random() < 0.45:
            site.put_at(bush, at, rng.uniform(0, 6), kerb.height_m, shown=green.grows())
