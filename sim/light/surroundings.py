"""What the light needs to know of a street: its lamps and its tunnels."""

from __future__ import annotations

from dataclasses import dataclass

from sim.light.lamps import LightSource
from sim.light.tunnels import CoveredRoad
from sim.streets.lamps import Lamp
from sim.streets.network import Network, Tunnel

# Illuminance at one metre, on a dark night and in a dark tunnel.
_INTENSITY = {"street": 1.6, "mast": 5.0, "tunnel": 1.0}
_RADIUS_M = {"street": 0.16, "mast": 0.3, "tunnel": 0.12}


@dataclass(frozen=True, eq=False)
class Surroundings:
    """The lamps and the dark places of one world.

    Attributes:
        lamps: Those that burn at night.
        tunnel_lamps: Those that burn in tunnels.
        tunnels: Covered stretches.
    """

    lamps: tuple[LightSource, ...] = ()
    tunnel_lamps: tuple[LightSource, ...] = ()
    tunnels: tuple[CoveredRoad, ...] = ()


def surroundings_of(network: Network, lamps: tuple[Lamp, ...]) -> Surroundings:
    """Return what shines and what is dark in a street."""
    sources = {
        inside: tuple(_source(lamp) for lamp in lamps if (lamp.kind == "tunnel") == inside)
        for inside in (False, True)
    }
    return Surroundings(
        sources[False], sources[True], tuple(_covered(network, one) for one in network.tunnels)
    )


def _source(lamp: Lamp) -> LightSource:
    return LightSource(lamp.position_m, lamp.aim, _INTENSITY[lamp.kind], radius_m=_RADIUS_M[lamp.kind])


def _covered(network: Network, tunnel: Tunnel) -> CoveredRoad:
    ground_m = max(float(network.relief.height_m(portal)) for portal in tunnel.portals_m)
    return CoveredRoad(tunnel.outline_m, tunnel.portals_m, ground_m + tunnel.height_m)
