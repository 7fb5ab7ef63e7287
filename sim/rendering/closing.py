"""What holds something of the graphics driver and gives it back at the end of its block."""

from __future__ import annotations

from types import TracebackType
from typing import Self


class Closing:
    """A context manager that closes itself, complete once constructed."""

    def close(self) -> None:
        """Free what is held; left to the interpreter's exit it would raise there."""
        raise NotImplementedError

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
