"""A sheet of thumbnails: every scenario with a few of its images, its name and its sentence."""

from __future__ import annotations

import multiprocessing
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import cv2
import numpy as np

from estimator.bundle import Image
from estimator.errors import InputError
from eval.console import Console
from eval.glimpse import Glimpse, take_glimpse
from eval.lettering import text_width_px, wrapped, write_text
from eval.mosaic import Picture
from eval.out_folder import creating

SUFFIXES = (".png", ".jpg")
_LARGE_PX, _SMALL_PX = (352, 220), (174, 108)
_INNER_PX, _OUTER_PX = 4, 22  # gaps between the images of a scenario, and between scenarios
_CELL_PX = (_LARGE_PX[0] + _INNER_PX + _SMALL_PX[0], _LARGE_PX[1] + 88)
_NAME_SIZE_PX, _ABOUT_SIZE_PX, _LINE_PX, _MOST_LINES = 19, 14, 18, 3
_PAPER, _INK, _PALE_INK, _NOTHING = (250, 250, 250), (25, 25, 25), (95, 95, 95), 40


def write_contact_sheet(names: Sequence[str], file: Path, workers: int, console: Console) -> None:
    """Render a glimpse of every scenario, several at a time, and write the sheet.

    Raises:
        InputError: The file exists, cannot be written, or has a suffix that is no picture's.
    """
    if file.suffix.lower() not in SUFFIXES:
        raise InputError(f"{file}: wanted a name that ends in {' or '.join(SUFFIXES)}")
    with creating(file) as unfinished:
        glimpses = _take_glimpses(names, workers, console)
        _, encoded = cv2.imencode(file.suffix.lower(), draw_sheet(glimpses))
        unfinished.write_bytes(encoded.tobytes())


def _take_glimpses(names: Sequence[str], workers: int, console: Console) -> list[Glimpse]:
    # fresh processes: OpenGL does not survive a fork
    context = multiprocessing.get_context("spawn")
    glimpses: list[Glimpse] = []
    with ProcessPoolExecutor(min(workers, len(names)), mp_context=context) as pool:
        for glimpse in pool.map(take_glimpse, names):
            glimpses.append(glimpse)
            console.progress("rendering", len(glimpses), len(names))
    return glimpses


def draw_sheet(glimpses: Sequence[Glimpse]) -> Picture:
    """Return the sheet, about as wide as high, read row by row."""
    columns = max(1, round((len(glimpses) * _CELL_PX[1] / _CELL_PX[0]) ** 0.5))
    rows = -(-len(glimpses) // columns)
    width, height = (
        count * (length + _OUTER_PX) + _OUTER_PX
        for count, length in zip((columns, rows), _CELL_PX, strict=True)
    )
    sheet = np.full((height, width, 3), _PAPER, np.uint8)
    for index, glimpse in enumerate(glimpses):
        row, column = divmod(index, columns)
        left, top = (
            number * (length + _OUTER_PX) + _OUTER_PX
            for number, length in zip((column, row), _CELL_PX, strict=True)
        )
        _draw_cell(sheet[top : top + _CELL_PX[1], left : left + _CELL_PX[0]], glimpse)
    return sheet


def _draw_cell(cell: Picture, glimpse: Glimpse) -> None:
    right = _LARGE_PX[0] + _INNER_PX
    places = [(0, 0, _LARGE_PX), (right, 0, _SMALL_PX), (right, _SMALL_PX[1] + _INNER_PX, _SMALL_PX)]
    for (left, top, size_px), camera in zip(places, glimpse.cameras, strict=False):
        tile = cell[top : top + size_px[1], left : left + size_px[0]]
        tile[:] = _covering(glimpse.images.get(camera), size_px)[..., np.newaxis]
    baseline = _LARGE_PX[1] + 24
    write_text(cell, glimpse.scenario, (0, baseline), _NAME_SIZE_PX, _INK, bold=True, shadow=False)
    for number, line in enumerate(_lines(glimpse.about), start=1):
        at_px = (0, baseline + 2 + number * _LINE_PX)
        write_text(cell, line, at_px, _ABOUT_SIZE_PX, _PALE_INK, shadow=False)


def _lines(about: str) -> list[str]:
    lines = wrapped(about, _ABOUT_SIZE_PX, _CELL_PX[0])
    if len(lines) <= _MOST_LINES:
        return lines
    last = lines[_MOST_LINES - 1]
    while text_width_px(f"{last} …", _ABOUT_SIZE_PX) > _CELL_PX[0]:
        last = last.rpartition(" ")[0]
    return [*lines[: _MOST_LINES - 1], f"{last} …"]


def _covering(image: Image | None, size_px: tuple[int, int]) -> Image:
    """Return the image cut and resized to fill a tile; a dark tile where there is none."""
    if image is None:
        return np.full(size_px[::-1], _NOTHING, np.uint8)
    factor = max(size_px[0] / image.shape[1], size_px[1] / image.shape[0])
    inner = max(size_px[0], round(image.shape[1] * factor)), max(size_px[1], round(image.shape[0] * factor))
    resized = cv2.resize(image, inner, interpolation=cv2.INTER_AREA)
    left, top = (inner[0] - size_px[0]) // 2, (inner[1] - size_px[1]) // 2
    return np.asarray(resized[top : top + size_px[1], left : left + size_px[0]], np.uint8)
