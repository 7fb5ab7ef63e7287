"""What lies between the world and the lens, and on the lens: the joint at which light and weather come in."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Protocol

import cv2
import numpy as np

from sim.rendering.view import Picture, RgbImage, View
from sim.sensing.face import GreyImage

_LUMA = np.array([[0.299, 0.587, 0.114]], np.float32)  # ITU-R BT.601


class Atmosphere(Protocol):
    """Turns pictures of pinholes into light, and covers what a lens made of them."""

    @property
    def needs_depth(self) -> bool:
        """Whether ``light`` wants pictures with depth."""

    def around(self, views: Mapping[str, View]) -> dict[str, View]:
        """Return what must be rendered, with depth, for ``look_around``; nothing where that is not wanted.

        Args:
            views: All of a camera's, for a whole image.
        """

    def look_around(
        self, pictures: Sequence[Picture], views: Sequence[View], camera: str, time_s: float
    ) -> None:
        """See what may be mirrored in a camera's next image; ``time_s`` is the middle of its exposure."""

    def light(self, picture: Picture, view: View, camera: str, time_s: float) -> GreyImage:
        """Return the (H, W) light that reaches a pinhole, in levels of a sunny day, not bounded by 255.

        Called for every picture that an image is made of: strips of rows, instants of a motion blur, faces
        of a wide lens. Must give the same light for the same ray however it is cut.
        """

    def cover(self, light: GreyImage, camera: str, time_s: float) -> GreyImage:
        """Return the (H, W) light of a whole image with what is on the lens (drops, flare) laid over it.

        ``time_s`` is the middle of its exposure.
        """


class ClearAir:
    """Nothing at all."""

    needs_depth = False

    def around(self, views: Mapping[str, View]) -> dict[str, View]:
        return {}

    def look_around(
        self, pictures: Sequence[Picture], views: Sequence[View], camera: str, time_s: float
    ) -> None:
        pass

    def light(self, picture: Picture, view: View, camera: str, time_s: float) -> GreyImage:
        return grey(picture.rgb)

    def cover(self, light: GreyImage, camera: str, time_s: float) -> GreyImage:
        return light


def grey(picture: RgbImage) -> GreyImage:
    """Return (H, W) luma of an (H, W, 3) picture, unrounded."""
    return np.asarray(cv2.transform(picture.astype(np.float32), _LUMA))
