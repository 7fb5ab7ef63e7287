"""A gateway through a house: streets leave the world through it, and traffic comes and goes in its dark."""

from __future__ import annotations

from dataclasses import replace

from sim.shapes.facade import Facade, Panel

GATE_FLOORS = (1, 2, 2, 3)  # choices for the upper floors of a house with a gateway
GATEWAY_M = 4.1  # height: lorries pass
_FRAME_M = 0.35


def with_gateway(facade: Facade, width_m: float) -> Facade:
    """Cut a gateway into the middle of a front, and leave out whatever it would cut through."""
    low, high = (facade.width_m - width_m) / 2, (facade.width_m + width_m) / 2
    frame = Panel(low - _FRAME_M, high + _FRAME_M, 0.0, GATEWAY_M + _FRAME_M, 0.08, "quoin")
    kept = [panel for panel in facade.panels if not _overlap(panel, frame)]
    bands = [side for panel in facade.panels if _is_band(panel, facade) for side in _beside(panel, frame)]
    opening = Panel(low, high, 0.0, GATEWAY_M, -0.4, "gateway")
    return replace(facade, panels=(*kept, *bands, frame, opening))


def _overlap(one: Panel, other: Panel) -> bool:
    return one.x0 < other.x1 and other.x0 < one.x1 and one.z0 < other.z1 and other.z0 < one.z1


def _is_band(panel: Panel, facade: Facade) -> bool:
    return panel.x1 - panel.x0 > 0.9 * facade.width_m


def _beside(band: Panel, frame: Panel) -> list[Panel]:
    """What a frame leaves of a band that it interrupts."""
    if not _overlap(band, frame):
        return []
    return [replace(band, x1=frame.x0), replace(band, x0=frame.x1)]
