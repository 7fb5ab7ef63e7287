"""One flat source picture of a lens, and which of the lens's samples are taken from where in it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import SE3

GreyImage = npt.NDArray[np.float32]
PixelMap = npt.NDArray[np.float32]  # (h, w, 2) source pixels
PixelRates = npt.NDArray[np.float32]  # (H, W, 2) px/s on the source's grid

BORDER_PX = 2  # room for interpolation at the rim of a source
DRIFT_MARGIN_PX = 8  # room for samples that are looked up where things were a moment before
_SAME_THING_PX = 0.3


@dataclass(frozen=True, eq=False)
class Face:
    """A pinhole to render, and the samples it serves.

    Attributes:
        pinhole: What is rendered.
        cam_from_face: Rotation from the pinhole's frame to the camera's.
        block: Rows and columns of the lens's samples that ``map_xy`` covers.
        map_xy: (h, w, 2) source pixel of each sample of the block.
        served: (h, w) which samples of the block the face serves; None for all.
        exact: Whether every sample is a source pixel, in order: then nothing is resampled.
    """

    pinhole: Camera
    cam_from_face: SE3
    block: tuple[slice, slice]
    map_xy: PixelMap
    served: npt.NDArray[np.bool_] | None = None
    exact: bool = False

    def paint(
        self,
        samples: GreyImage,
        light: GreyImage,
        rates: PixelRates | None = None,
        delay_s: npt.NDArray[np.float32] | None = None,
    ) -> None:
        """Write the served samples into the lens's.

        Args:
            samples: All samples of the lens; only those that the face serves are written.
            light: The source picture.
            rates: How fast what is seen at each source pixel moves; None for a still picture.
            delay_s: (rows of samples,) how long after the source picture each row is exposed.
        """
        target = samples[self.block]
        map_xy, kernel = self.map_xy, cv2.INTER_CUBIC
        if rates is not None and delay_s is not None:
            map_xy = _where_it_was(map_xy, rates, delay_s[self.block[0], None, None])
            kernel = cv2.INTER_LANCZOS4  # the cubic one shifts what is between pixels by up to 0.05 px
        elif self.exact:
            target[:] = light
            return
        values = cv2.remap(light, map_xy, None, kernel, borderMode=cv2.BORDER_REPLICATE)
        if self.served is None:
            target[:] = values
        else:
            np.copyto(target, values, where=self.served)

    def rows(self, first: int, last: int, margin_px: int) -> Face | None:
        """Return the part that serves rows ``first`` to ``last`` of samples; None if there is none.

        Its pinhole shows only what those samples need and ``margin_px`` around it; without a margin
        nothing beyond this face's own picture. Its block counts from ``first``.
        """
        start = self.block[0].start
        low, high = max(first, start), min(last, self.block[0].stop)
        if low >= high:
            return None
        within = slice(low - start, high - start)
        served = None if self.served is None else self.served[within]
        columns = slice(0, self.map_xy.shape[1])
        if served is not None:
            used = np.flatnonzero(served.any(axis=0))
            if not used.size:
                return None
            columns = slice(int(used[0]), int(used[-1]) + 1)
            served = served[:, columns]
        map_xy = self.map_xy[within, columns]
        offset = self.block[1].start
        block = (slice(low - first, high - first), slice(offset + columns.start, offset + columns.stop))
        part = replace(self, block=block, map_xy=map_xy, served=served)
        return part._cropped(margin_px)

    def _cropped(self, margin_px: int) -> Face:
        places = self.map_xy.reshape(-1, 2) if self.served is None else self.map_xy[self.served]
        border_px = margin_px + (0 if self.exact else BORDER_PX)
        low = np.floor(places.min(0)).astype(int) - border_px
        high = np.ceil(places.max(0)).astype(int) + border_px
        if not margin_px:
            low, high = np.maximum(low, 0), np.minimum(high, np.array(self.pinhole.size_px) - 1)
        center_px = np.array(self.pinhole.center_px) - low
        size_px = (int(high[0] - low[0]) + 1, int(high[1] - low[1]) + 1)
        pinhole = replace(self.pinhole, size_px=size_px, center_px=(float(center_px[0]), float(center_px[1])))
        return replace(self, pinhole=pinhole, map_xy=self.map_xy - low.astype(np.float32))


def _where_it_was(map_xy: PixelMap, rates: PixelRates, delay_s: npt.NDArray[np.float32]) -> PixelMap:
    """Return the place in the source picture of what reaches each sample ``delay_s`` after it.

    What counts is the rate at that place, not where it arrives; but where the two are of different things,
    one uncovers the other, and what is uncovered is taken from beside it.
    """
    arriving = delay_s * cv2.remap(rates, map_xy, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    place = map_xy - arriving
    leaving = delay_s * cv2.remap(rates, place, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    same = (np.abs(leaving - arriving) < _SAME_THING_PX).all(axis=-1, keepdims=True)
    return np.asarray(np.where(same, map_xy - leaving, place))
