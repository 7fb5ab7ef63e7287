"""Guess which of several names a misspelt one was meant to be."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches


def did_you_mean(wrong: str, names: Iterable[str]) -> str:
    """Return `` (did you mean 'this'?)``, or nothing where no name is close."""
    close = get_close_matches(wrong, names, n=1)
    return f" (did you mean {close[0]!r}?)" if close else ""
