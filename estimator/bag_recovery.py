"""The readable part of an MCAP file without a usable index: never finished, or with a hole in it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from itertools import chain, pairwise
from pathlib import Path

from mcap.reader import NonSeekingReader
from mcap.records import Channel, Message, Schema

from estimator.bag_message import BagMessage

_Found = tuple[Schema | None, Channel, Message]


class BrokenSource:
    """A broken MCAP file, up to a chunk (1 MiB) short of the break. Scanned once when made."""

    def __init__(self, file: Path, break_reason: str) -> None:
        self._file = file
        self.break_reason: str | None = break_reason
        types: dict[str, str] = {}
        counts: Counter[str] = Counter()
        for message in self._read(None):
            types[message.topic] = message.message_type
            counts[message.topic] += 1
        self.message_types: Mapping[str, str] = types
        self.message_counts: Mapping[str, int] = counts

    def messages(self, topics: Collection[str]) -> Iterator[BagMessage]:
        """Yield the messages of some topics in the order of the file."""
        return self._read(frozenset(topics))

    def _read(self, topics: Collection[str] | None) -> Iterator[BagMessage]:
        with self._file.open("rb") as stream:
            # the default order would read everything before it yields, and so meet the break first
            reader = NonSeekingReader(stream, validate_crcs=True)
            for schema, channel, message in _before_break(reader.iter_messages(log_time_order=False)):
                wanted = topics is None or channel.topic in topics
                if wanted and channel.message_encoding == "cdr" and schema is not None:
                    yield BagMessage(channel.topic, schema.name, message.data)


def _before_break(found: Iterator[_Found]) -> Iterator[_Found]:
    """Yield what is found before the break but for the last, which may reach into it where no CRC tells."""
    try:
        for each, _ in pairwise(chain(found, [None])):
            if each is not None:
                yield each
    except Exception:  # the break: EndOfFile, ZstdError, struct.error, ... by where it fell
        return
