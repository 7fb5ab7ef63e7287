"""One image on its way from a camera to the recorder: what it shows, and what it says about itself."""

from __future__ import annotations

from dataclasses import dataclass

from estimator.bundle import Image


@dataclass(frozen=True, eq=False)
class Frame:
    """An image as it travels.

    Attributes:
        camera: Whose topic it comes on.
        stamp_ns: ``header.stamp``: when the camera's clock says it was exposed.
        arrival_ns: When the recorder gets it, on the recorder's clock.
        image: (H, W) grey.
    """

    camera: str
    stamp_ns: int
    arrival_ns: int
    image: Image
