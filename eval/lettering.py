"""Text on pictures, in the typeface that OpenCV carries."""

from __future__ import annotations

from functools import cache
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt

_DARK = (0, 0, 0)
_REGULAR, _BOLD = 400, 700


@cache
def _face() -> Any:
    return cv2.FontFace("sans")


def write_text(
    picture: npt.NDArray[np.uint8],
    text: str,
    at_px: tuple[int, int],
    size_px: int,
    color: tuple[int, int, int],
    *,
    bold: bool = False,
    shadow: bool = True,
) -> None:
    """Write a line into a BGR picture, its baseline's left end at ``at_px``; a shadow keeps it legible."""
    weight = _BOLD if bold else _REGULAR
    block = np.ascontiguousarray(picture)
    if shadow:
        cv2.putText(block, text, (at_px[0] + 1, at_px[1] + 1), _DARK, _face(), size_px, weight)
    cv2.putText(block, text, at_px, color, _face(), size_px, weight)
    picture[:] = block


def text_width_px(text: str, size_px: int, *, bold: bool = False) -> int:
    """Return how far a line of text reaches."""
    weight = _BOLD if bold else _REGULAR
    _, _, width, _ = cv2.getTextSize((4096, 256), text, (0, 128), _face(), size_px, weight)
    return int(width)


def wrapped(text: str, size_px: int, width_px: int) -> list[str]:
    """Break a text into lines that fit a width; a single word may stand out."""
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and text_width_px(longer, size_px) <= width_px:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines
