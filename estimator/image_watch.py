"""Watch the images themselves: cameras that send none, one and the same, or nothing to be seen."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from pydantic import Field

from estimator.bundle import FrameBundle, Image
from estimator.config import Config
from estimator.finding import Finding, FindingKind
from estimator.ranges import Count, PositiveCount, StepCount
from estimator.rig import Rig


class ImageWatchConfig(Config):
    """How many bundles in a row make a finding and end it, and what counts as nothing to be seen."""

    begins_after: PositiveCount = 10
    ends_after: PositiveCount = 3
    min_contrast: float = Field(10.0, ge=0, le=255)  # levels between the 2nd and the 98th percentile
    min_corners: Count = 20
    stride_px: StepCount = 7


class ImageWatch:
    """Counts, for every camera and kind of trouble, how long it has lasted."""

    def __init__(self, rig: Rig, config: ImageWatchConfig) -> None:
        self._rig = rig
        self._config = config
        self._last: dict[str, Image] = {}
        kinds = (FindingKind.NO_IMAGE, FindingKind.NO_TEXTURE, FindingKind.FROZEN_IMAGE)
        self._spells = {(kind, name): _Spell(config) for kind in kinds for name in rig.cameras}
        self._shape: dict[str, str] = {}

    def usable(self, bundle: FrameBundle) -> FrameBundle:
        """Return the bundle without what is no image of the rig: other cameras, sizes or kinds of pixels."""
        images = {}
        self._shape = {}
        for name, image in bundle.images.items():
            if name not in self._rig.cameras or not isinstance(image, np.ndarray):
                continue
            width, height = self._rig[name].camera.size_px
            if image.shape == (height, width) and image.dtype == np.uint8:
                images[name] = image
            else:
                self._shape[name] = f"{image.dtype} {' x '.join(map(str, image.shape[::-1]))}"
        return FrameBundle(bundle.stamp_ns, images)

    def see(self, bundle: FrameBundle, corner_count: Mapping[str, int], repeats: frozenset[str]) -> None:
        """Take note of a bundle, of how many corners are followed in each image, and of repeated images."""
        others_move = len(repeats) < len(bundle.images)
        for (kind, name), spell in self._spells.items():
            image = bundle.images.get(name)
            if kind is FindingKind.NO_IMAGE:
                spell.count(image is None)
            elif image is None:
                continue
            elif kind is FindingKind.FROZEN_IMAGE:
                spell.count(name in repeats and others_move)
            else:
                few = corner_count.get(name, 0) < self._config.min_corners
                spell.count(few and self._contrast(image) < self._config.min_contrast)
        self._last |= bundle.images

    def findings(self) -> Iterator[Finding]:
        """Yield what lasts."""
        for (kind, name), spell in self._spells.items():
            if spell.lasts:
                about = self._about(kind, name, spell.length)
                yield Finding(kind, (name,), about, doubtful=False)

    def _about(self, kind: FindingKind, name: str, length: int) -> str:
        consequence = (
            "nothing can be calibrated meanwhile, because the car's motion comes from it"
            if name == self._rig.reference
            else "its pose stays as it was known before"
        )
        if kind is FindingKind.FROZEN_IMAGE:
            return f"{name} has sent its last image once more, to the byte, {length} times; {consequence}"
        if kind is FindingKind.NO_TEXTURE:
            level = int(np.median(self._sample(self._last[name])))
            return f"{name} has shown nothing, level {level} of 255, for {length} images; {consequence}"
        if name in self._shape:
            width, height = self._rig[name].camera.size_px
            return (
                f"{name} has sent no usable image for {length} bundles: got {self._shape[name]}, "
                f"wanted uint8 {width} x {height}; {consequence}"
            )
        return f"{name} has sent no image for {length} bundles; {consequence}"

    def _contrast(self, image: Image) -> float:
        low, high = np.percentile(self._sample(image), [2, 98])
        return float(high - low)

    def _sample(self, image: Image) -> Image:
        return image[:: self._config.stride_px, :: self._config.stride_px]


class _Spell:
    """Something begins when it was so a few times in a row, and ends when it was not so a few times in a row.

    Attributes:
        lasts: Whether it has begun and not ended.
        length: How many times it was so since it was last otherwise before it began.
    """

    def __init__(self, config: ImageWatchConfig) -> None:
        self._config = config
        self._missed = 0
        self.length = 0
        self.lasts = False

    def count(self, is_so: bool) -> None:
        self._missed = 0 if is_so else self._missed + 1
        if is_so:
            self.length += 1
            self.lasts = self.lasts or self.length >= self._config.begins_after
        elif not self.lasts or self._missed >= self._config.ends_after:
            self.length, self.lasts = 0, False
