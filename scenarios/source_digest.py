"""One number for the code that makes a recording, so that a changed world is never served from the cache."""

from __future__ import annotations

import hashlib
from pathlib import Path

HOUSE = Path(__file__).parent.parent
# What sim imports of estimator. The estimator's algorithms are not among them: they change no recording.
VOCABULARY = tuple(
    f"estimator/{name}.py"
    for name in (
        *("bundle", "camera", "config", "distortion", "distortion_angle"),
        *("errors", "fold", "rig", "se3"),
    )
)


def source_digest(house: Path = HOUSE) -> str:
    """Return a SHA-256 over the sources of ``sim`` and of the vocabulary it uses, below ``house``."""
    content = hashlib.sha256()
    for path in sorted([*(house / "sim").rglob("*.py"), *(house / name for name in VOCABULARY)]):
        content.update(f"{path.relative_to(house)}\n".encode())
        content.update(hashlib.sha256(path.read_bytes()).digest())
    return content.hexdigest()
