"""Whole bags, and the parsing of messages: all that touches rosbags."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import Any

from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_typestore

from estimator.bag_message import BagMessage
from estimator.errors import InputError

_TYPES = get_typestore(Stores.ROS2_JAZZY)


def parse(message: BagMessage) -> Any:
    """Return a message with its fields as attributes.

    Raises:
        InputError: The bytes are no message of that type.
    """
    try:
        return _TYPES.deserialize_cdr(message.cdr, message.message_type)
    except Exception as error:  # rosbags lets struct, index, value and assertion errors through
        reason = " ".join(str(error).split()) or type(error).__name__
        raise InputError(f"{message.topic}: got bytes that are no {message.message_type}: {reason}") from None


class IntactSource:
    """A bag folder, or a single MCAP or sqlite3 file, that has its end; a context manager."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self.break_reason: str | None = None
        self.message_types: Mapping[str, str] = {}
        self.message_counts: Mapping[str, int] = {}

    def __enter__(self) -> IntactSource:
        try:
            self._reader = Reader(self._path)
            self._reader.open()
        except Exception as error:  # not only ReaderError: OSError, ZstdError, TypeError of a cut record, ...
            raise InputError(" ".join(str(error).split()) or type(error).__name__) from None
        counts: Counter[str] = Counter()
        for connection in self._reader.connections:
            counts[connection.topic] += connection.msgcount
        self.message_counts = counts
        self.message_types = {each.topic: each.msgtype for each in self._reader.connections}
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._reader.close()

    def messages(self, topics: Collection[str]) -> Iterator[BagMessage]:
        """Yield the messages of some topics in the order of the log, up to the first unreadable chunk."""
        connections = [each for each in self._reader.connections if each.topic in topics]
        if not connections:
            return
        try:
            for connection, _log_time, cdr in self._reader.messages(connections):
                yield BagMessage(connection.topic, connection.msgtype, bytes(cdr))
        except Exception as error:  # a damaged chunk: whatever the decompressor or the parser makes of it
            self.break_reason = "damaged: " + (" ".join(str(error).split()) or type(error).__name__)
