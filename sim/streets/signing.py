"""What tells traffic what to do: lights or signs where roads meet, signs at crossings, names at corners."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sim.shapes.signals import signal_post
from sim.streets.catalogue import PLATES, SKINS, Catalogue, furniture_skin
from sim.streets.network import Network
from sim.streets.placing import TO_STREET, TO_TRAFFIC, KerbSite, Thing
from sim.streets.road import Road

STREET_NAMES = (
    "LINDENWEG", "MARKTGASSE", "HAFENSTR", "AM TOR", "MUEHLENWEG", "SCHULSTR", "BAHNHOFSTR", "RINGSTR",
    "GARTENWEG", "KIRCHGASSE", "ALTE GASSE", "UFERSTR", "NEUE STR", "BERGWEG", "POSTSTR", "BREITE STR",
)  # fmt: skip
_FROM_KERB_M = 0.38
_SIGHT_M = (0.4, 6.0)  # from the end of a corner or crossing: where a sign for it may stand


def draw_names(rng: np.random.Generator) -> list[tuple[str, ...]]:
    """Names for the plates of every coat of furniture, all different."""
    drawn = rng.permutation(STREET_NAMES)[: SKINS * PLATES].reshape(SKINS, PLATES)
    return [tuple(str(name) for name in row) for row in drawn]


def sign_junctions(streets: Sequence[KerbSite], network: Network, catalogue: Catalogue) -> None:
    """Lights where a road crosses another, else signs; plates and bollards at every corner."""
    signalled = _has_crossroads(network)
    lights = [Thing(signal_post(green), furniture_skin(0), (0.2, 0.4)) for green in (False, True)]
    for street in streets:
        for k, (low, high) in enumerate(street.kerb.corners_m):
            road = _road_at(street, high, network)
            if signalled:
                light = lights[0 if road.gives_way else 1]
                _put_after(street, light, high)
            else:
                _put_after(street, catalogue.signs[("give_way",) if road.gives_way else ("priority",)], high)
            plate = catalogue.plates[(hash_of(road.name) + k) % len(catalogue.plates)]
            _put_before(street, plate, low, TO_STREET)
            for step in range(3):
                street.put(catalogue.bollard, low - 0.3 - 1.4 * step, 0.3, 0.0)
                street.put(catalogue.bollard, high + 0.3 + 1.4 * step, 0.3, 0.0)


def sign_crossings(streets: Sequence[KerbSite], catalogue: Catalogue) -> None:
    """A sign before every zebra crossing, and a warning some way before bends and corners."""
    for street in streets:
        corners = set(street.kerb.corners_m)
        for span in street.kerb.keep_clear_m:
            if span not in corners:
                _put_after(street, catalogue.signs["crossing",], span[1])
        for _, high in street.kerb.corners_m:
            street.put(catalogue.signs["warning", "limit"], high + 16.0, _FROM_KERB_M, TO_TRAFFIC)


def hash_of(name: str) -> int:
    """A small number that depends on a name alone."""
    return sum((k + 1) * ord(letter) for k, letter in enumerate(name))


def _has_crossroads(network: Network) -> bool:
    """Whether two mouths of a road lie opposite each other."""
    for road in network.roads:
        left = [(low + high) / 2 for low, high, side in road.mouths_m if side > 0]
        right = [(low + high) / 2 for low, high, side in road.mouths_m if side < 0]
        if any(abs(a - b) < 3.0 for a in left for b in right):
            return True
    return False


def _road_at(street: KerbSite, s_m: float, network: Network) -> Road:
    """The road along which a kerb runs at s."""
    point = street.kerb.path.point_m(s_m)

    def off_m(road: Road) -> float:
        s, d = road.path.project(point)
        beyond = max(road.path.start_m - float(s), float(s) - road.path.end_m, 0.0)
        return min(abs(float(d) - road.left_m), abs(float(d) - road.right_m)) + beyond

    return min(network.roads, key=off_m)


def _put_after(street: KerbSite, thing: Thing, s_m: float) -> bool:
    """Behind a corner or crossing along the kerb, which is before it for the traffic beside the kerb."""
    spots = np.arange(s_m + _SIGHT_M[0], s_m + _SIGHT_M[1], 0.3)
    return any(street.put(thing, s, _FROM_KERB_M, TO_TRAFFIC) for s in spots)


def _put_before(street: KerbSite, thing: Thing, s_m: float, turn_rad: float) -> bool:
    spots = np.arange(s_m - _SIGHT_M[0], s_m - _SIGHT_M[1], -0.3)
    return any(street.put(thing, s, _FROM_KERB_M, turn_rad) for s in spots)
