"""Messages of a ROS 2 bag by topic, whole or broken off, without a meaning given to any topic.

Whole files are read by rosbags; a file that was never finished, or has lost a piece, is read up to its break
by ``estimator.bag_recovery``. Who wants images asks ``estimator.recording``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType

from estimator.bag_files import begins_as_mcap, ends_as_mcap, explain_unreadable, storage_files
from estimator.bag_message import BagMessage, MessageSource
from estimator.bag_recovery import BrokenSource
from estimator.bag_rosbags import IntactSource
from estimator.errors import InputError


class Bag:
    """An open bag; a context manager.

    Attributes:
        path: What the user named: the bag's folder or one storage file.
        message_types: By topic, the type of its messages.
        message_counts: By topic, how many messages can be read.
    """

    def __init__(self, path: Path | str) -> None:
        """Open a bag.

        Raises:
            InputError: Nothing there, or nothing that is a ROS 2 bag.
        """
        self.path = Path(path)
        self._stack = ExitStack()
        try:
            self._sources = self._open_sources()
        except OSError as error:
            raise InputError(f"{self.path}: cannot read this recording: {error.strerror}") from None
        self.message_types: Mapping[str, str] = {
            topic: kind for source in self._sources for topic, kind in source.message_types.items()
        }
        counts: Counter[str] = Counter()
        for source in self._sources:
            counts.update(source.message_counts)
        self.message_counts: Mapping[str, int] = counts

    @property
    def break_reason(self) -> str | None:
        """Why the bag cannot be read to its end; None while no break is known."""
        return next((each.break_reason for each in self._sources if each.break_reason), None)

    def messages(self, topics: Collection[str]) -> Iterator[BagMessage]:
        """Yield the messages of some topics in the order of the log, up to the break if there is one."""
        for source in self._sources:
            yield from source.messages(topics)
            if source.break_reason:
                return

    def __enter__(self) -> Bag:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        self._stack.close()

    def _open_sources(self) -> list[MessageSource]:
        if (self.path / "metadata.yaml").is_file():
            try:
                return [self._stack.enter_context(IntactSource(self.path))]
            except InputError:
                pass  # perhaps only the metadata or only one file is broken: look at each file
        return [self._open_file(file) for file in storage_files(self.path)]

    def _open_file(self, file: Path) -> MessageSource:
        try:
            return self._stack.enter_context(IntactSource(file))
        except InputError as error:
            if begins_as_mcap(file):
                if not ends_as_mcap(file):
                    return BrokenSource(file, "truncated")
                broken = BrokenSource(file, f"damaged: {error}")
                if broken.message_counts:  # else it is whole, but no bag
                    return broken
            self._stack.close()
            raise InputError(f"{file}: {explain_unreadable(file, str(error))}") from None
