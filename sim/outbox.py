"""Put what is posted out of turn into the order in which it arrives."""

from __future__ import annotations

import heapq
from collections.abc import Callable
from itertools import count
from typing import Generic, TypeVar

T = TypeVar("T")


class Outbox(Generic[T]):
    """Holds what arrives later; of things that arrive at once, the first posted goes first."""

    def __init__(self, send: Callable[[int, T], None]) -> None:
        """Take what is called with the arrival time and the thing, in order."""
        self._send = send
        self._waiting: list[tuple[int, int, T]] = []
        self._numbers = count()

    def post(self, arrival_ns: int, thing: T) -> None:
        heapq.heappush(self._waiting, (arrival_ns, next(self._numbers), thing))

    def deliver(self, until_ns: int | None = None) -> None:
        """Send what has arrived by ``until_ns``, or everything; nothing earlier may be posted afterwards."""
        while self._waiting and (until_ns is None or self._waiting[0][0] <= until_ns):
            arrival_ns, _, thing = heapq.heappop(self._waiting)
            self._send(arrival_ns, thing)
