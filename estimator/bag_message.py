"""One message of a bag, and what a reader of bags offers."""

from __future__ import annotations

import struct
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Protocol


@dataclass(frozen=True, eq=False)
class BagMessage:
    """A message as stored.

    Attributes:
        topic: Its topic.
        message_type: ``sensor_msgs/msg/Image`` and the like.
        cdr: The serialised message with its encapsulation header.
    """

    topic: str
    message_type: str
    cdr: bytes

    @property
    def header_stamp_ns(self) -> int:
        """``header.stamp``, read without parsing the rest; for types whose first field is the header."""
        order = "<" if self.cdr[1] & 1 else ">"
        seconds, nanoseconds = struct.unpack_from(f"{order}iI", self.cdr, 4)
        return int(seconds) * 1_000_000_000 + int(nanoseconds)


class MessageSource(Protocol):
    """One storage, or several read as one.

    ``break_reason`` tells why it cannot be read to its end; for a storage that opened well it is known only
    once the break has been met.
    """

    message_types: Mapping[str, str]
    message_counts: Mapping[str, int]
    break_reason: str | None

    def messages(self, topics: Collection[str]) -> Iterator[BagMessage]:
        """Yield the messages of some topics in the order of the log."""
