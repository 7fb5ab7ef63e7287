"""The images of all cameras in one picture, laid out as the cameras sit on the car."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from estimator.bundle import Image
from estimator.rig import Rig
from estimator.se3 import SE3
from eval.lettering import write_text

Picture = npt.NDArray[np.uint8]  # (H, W, 3) BGR

_TILE_PX = (480, 300)
_GAP_PX = 4
_HEADER_PX = 40
_BACKGROUND = (24, 22, 20)
_PALE = (235, 235, 235)
_WARNING = (90, 160, 255)


def rows_of(rig: Rig) -> tuple[tuple[str, ...], ...]:
    """Return the cameras that look ahead, and those that look back, each row from left to right."""
    bearing_deg = {name: _bearing_deg(mounted.ego_from_cam) for name, mounted in rig.cameras.items()}
    ahead = [name for name in rig.cameras if abs(bearing_deg[name]) < 90]
    back = [name for name in rig.cameras if abs(bearing_deg[name]) >= 90]
    ahead.sort(key=lambda name: (-round(bearing_deg[name] / 5), -rig[name].ego_from_cam.translation[1]))
    back.sort(key=lambda name: bearing_deg[name] % 360)
    return tuple(tuple(row) for row in (ahead, back) if row)


def _bearing_deg(ego_from_cam: SE3) -> float:
    """Return where a camera looks, counted from straight ahead to the left."""
    axis = ego_from_cam.rotation[:, 2]
    return float(np.degrees(np.arctan2(axis[1], axis[0])))


@dataclass(frozen=True)
class Mosaic:
    """Lays images out in rows, each row centred, below a line of text."""

    rows: tuple[tuple[str, ...], ...]

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height, both even as video wants them."""
        columns = max(len(row) for row in self.rows)
        width = columns * (_TILE_PX[0] + _GAP_PX) + _GAP_PX
        height = _HEADER_PX + len(self.rows) * (_TILE_PX[1] + _GAP_PX)
        return width + width % 2, height + height % 2

    def compose(self, images: Mapping[str, Image], stale: frozenset[str], header: str) -> Picture:
        """Return one picture; a camera without an image stays dark, one in ``stale`` is shown dimmed."""
        width, height = self.size_px
        picture = np.full((height, width, 3), _BACKGROUND, np.uint8)
        write_text(picture, header, (12, 28), 22, _PALE)
        for number, row in enumerate(self.rows):
            top = _HEADER_PX + number * (_TILE_PX[1] + _GAP_PX)
            left = (width - len(row) * (_TILE_PX[0] + _GAP_PX) + _GAP_PX) // 2
            for name in row:
                tile = picture[top : top + _TILE_PX[1], left : left + _TILE_PX[0]]
                _fill(tile, images.get(name), name, name in stale)
                left += _TILE_PX[0] + _GAP_PX
        return picture


def _fill(tile: Picture, image: Image | None, name: str, is_stale: bool) -> None:
    if image is not None:
        shown = _fitted(image, (tile.shape[1], tile.shape[0]))
        tile[:] = (shown // 3 if is_stale else shown)[..., np.newaxis]
    write_text(tile, name, (10, 24), 18, _PALE)
    if image is None or is_stale:
        write_text(tile, "no image", (10, tile.shape[0] - 14), 18, _WARNING)


def _fitted(image: Image, size_px: tuple[int, int]) -> Image:
    """Return the image as large as fits, black beside it."""
    factor = min(size_px[0] / image.shape[1], size_px[1] / image.shape[0])
    inner = max(1, round(image.shape[1] * factor)), max(1, round(image.shape[0] * factor))
    shrinking = cv2.INTER_AREA if factor < 1 else cv2.INTER_LINEAR
    result = np.zeros((size_px[1], size_px[0]), np.uint8)
    top, left = (size_px[1] - inner[1]) // 2, (size_px[0] - inner[0]) // 2
    result[top : top + inner[1], left : left + inner[0]] = cv2.resize(image, inner, interpolation=shrinking)
    return result
