"""Group images of several cameras into bundles by their stamps, streaming."""

from __future__ import annotations

from bisect import insort
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Generic, TypeVar

import numpy as np

T = TypeVar("T")

_GAP_FRACTION = 0.25  # of the period: stamps of one bundle follow each other this closely
_SPAN_FRACTION = 0.5  # of the period: a bundle is never longer than this
_LEAST_HOLD_NS = 500_000_000
_HOLD_PERIODS = 5


@dataclass(frozen=True, order=True)
class Stamped(Generic[T]):
    """What a camera gave at an instant."""

    stamp_ns: int
    camera: str
    payload: T = field(compare=False)


@dataclass
class Bundler(Generic[T]):
    """Groups a stream that is nearly, but not quite, in the order of stamps.

    Images are held until one is ``hold`` newer, half a second or five periods, then grouped in the order of
    stamps. So memory is bounded, and the order of topics and of delivery within that time does not matter.

    Attributes:
        period_ns: Time between images of the reference camera.
        reference: The camera whose stamp is the bundle's.
        late_count: Images left out because their time had already been passed on.
        repeated_count: Images left out because the camera had already given one of the same stamp.
    """

    period_ns: float
    reference: str
    late_count: int = 0
    repeated_count: int = 0

    def groups(self, stream: Iterable[Stamped[T]]) -> Iterator[tuple[int, list[Stamped[T]]]]:
        """Yield (stamp_ns, members) in strictly increasing order of stamps, no camera twice in a group."""
        group: list[Stamped[T]] = []
        for item in self._sorted(stream):
            if group and not self._belongs(item, group):
                yield self._stamp_ns(group), group
                group = []
            group.append(item)
        if group:
            yield self._stamp_ns(group), group

    def _sorted(self, stream: Iterable[Stamped[T]]) -> Iterator[Stamped[T]]:
        hold_ns = max(_LEAST_HOLD_NS, _HOLD_PERIODS * self.period_ns)
        held: list[Stamped[T]] = []
        passed_ns: int | None = None
        for item in stream:
            if passed_ns is not None and item.stamp_ns <= passed_ns:
                self.late_count += 1
            elif item in held:
                self.repeated_count += 1
            else:
                insort(held, item)
            while held[-1].stamp_ns - held[0].stamp_ns > hold_ns:
                passed_ns = held[0].stamp_ns
                yield held.pop(0)
        yield from held

    def _belongs(self, item: Stamped[T], group: Sequence[Stamped[T]]) -> bool:
        return (
            item.stamp_ns - group[-1].stamp_ns <= _GAP_FRACTION * self.period_ns
            and item.stamp_ns - group[0].stamp_ns <= _SPAN_FRACTION * self.period_ns
            and all(item.camera != member.camera for member in group)
        )

    def _stamp_ns(self, group: Sequence[Stamped[T]]) -> int:
        for member in group:
            if member.camera == self.reference:
                return member.stamp_ns
        return group[len(group) // 2].stamp_ns


def period_ns(stamps_ns: Sequence[int]) -> float | None:
    """Return the median gap between the stamps of one camera, or None for fewer than two instants."""
    gaps = np.diff(np.unique(np.asarray(stamps_ns, np.int64)))
    return float(np.median(gaps)) if len(gaps) else None
