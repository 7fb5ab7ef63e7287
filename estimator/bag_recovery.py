"""The readable part of an MCAP file that was never finished: no footer, no index, perhaps half a chunk."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

from mcap.reader import NonSeekingReader

from estimator.bag_message import BagMessage


class BrokenSource:
    """A broken-off MCAP file, up to a chunk (1 MiB) short of the break. Scanned once when made."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self.break_reason: str | None = "truncated"
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
            found = NonSeekingReader(stream).iter_messages(topics, log_time_order=False)
            while True:
                try:
                    schema, channel, message = next(found)
                except StopIteration:
                    return
                except Exception:  # the break: EndOfFile, ZstdError, struct.error, by where the cut fell
                    return
                if channel.message_encoding == "cdr" and schema is not None:
                    yield BagMessage(channel.topic, schema.name, message.data)
