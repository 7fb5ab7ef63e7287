"""One number for the code that makes a result, so that a resumed sweep never mixes two versions of it."""

from __future__ import annotations

import hashlib
import inspect
from functools import cache
from pathlib import Path

from estimator.interface import EstimatorFactory

_ROOMS = ("estimator", "sim", "scenarios", "eval")


def code_digest(make_estimator: EstimatorFactory) -> str:
    """Return a SHA-256 over the source of every room and of the module that the estimator is in."""
    content = hashlib.sha256(_rooms_digest().encode())
    try:
        content.update(Path(inspect.getfile(make_estimator)).read_bytes())
    except (TypeError, OSError):
        content.update(repr(make_estimator).encode())
    return content.hexdigest()


@cache
def _rooms_digest() -> str:
    house = Path(__file__).parent.parent
    content = hashlib.sha256()
    for room in _ROOMS:
        for path in sorted((house / room).rglob("*.py")):
            content.update(str(path.relative_to(house)).encode() + path.read_bytes())
    return content.hexdigest()
