"""Cameras whose shutter follows a clock of their own: in step by their stamps, not in what they show."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Generic, Protocol, TypeVar

from estimator.bundle import Image
from sim.faults.clock_faults import ClockOffset
from sim.faults.fault import Fault
from sim.rendering.view import Renderer
from sim.stage import Stage

LensT = TypeVar("LensT")


class Cameras(Protocol):
    """Cameras that all take their image at one time."""

    def take(self, stage: Stage, renderer: Renderer, index: int, time_s: float) -> dict[str, Image]:
        """Return each camera's image of bundle ``index``, exposed at ``time_s``."""


@dataclass
class _Group:
    """Cameras on one clock."""

    cameras: Cameras
    offsets: tuple[ClockOffset, ...]
    _last_s: float = field(default=-float("inf"))

    def take(self, stage: Stage, renderer: Renderer, index: int, time_s: float) -> dict[str, Image]:
        ahead_s = sum(fault.offset_ms / 1000 for fault in self.offsets if fault.lasts(time_s))
        # a clock set forward while the car drives would ask for a second look at the past
        self._last_s = max(time_s - ahead_s, self._last_s)
        return self.cameras.take(stage, renderer, index, self._last_s)


class CamerasOnClocks(Generic[LensT]):
    """Takes each camera's image when its own clock says that it is time."""

    def __init__(
        self,
        lenses: Mapping[str, LensT],
        make_cameras: Callable[[Mapping[str, LensT]], Cameras],
        faults: Sequence[Fault],
    ) -> None:
        """Take the lenses, what makes cameras of some of them, and all faults of the drive."""
        self._names = tuple(lenses)
        by_clock: dict[tuple[int, ...], list[str]] = {}
        offsets = [fault for fault in faults if isinstance(fault, ClockOffset)]
        for name in lenses:
            clock = tuple(index for index, fault in enumerate(offsets) if fault.concerns(name))
            by_clock.setdefault(clock, []).append(name)
        self._groups = [
            _Group(
                make_cameras({name: lenses[name] for name in names}),
                tuple(offsets[index] for index in clock),
            )
            for clock, names in by_clock.items()
        ]

    def take(self, stage: Stage, renderer: Renderer, index: int, time_s: float) -> dict[str, Image]:
        """Return each camera's image of bundle ``index``, due at ``time_s``."""
        images: dict[str, Image] = {}
        for group in self._groups:
            images |= group.take(stage, renderer, index, time_s)
        return {name: images[name] for name in self._names}
