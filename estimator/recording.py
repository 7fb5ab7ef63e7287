"""A recorded drive as bundles: reads the images of a ROS 2 bag and nothing else from it.

Topic order, start time and rate of the recording do not matter; one pass, bounded memory.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import TracebackType

from estimator.bag import Bag
from estimator.bag_message import BagMessage
from estimator.bundle import FrameBundle, Image
from estimator.bundling import Bundler, Stamped
from estimator.camera_image import ImageSizeError, read_image
from estimator.camera_topics import find_camera_topics
from estimator.errors import InputError
from estimator.look_ahead import look_ahead
from estimator.rig import Rig


class Recording:
    """An open recording, checked against the rig; a context manager.

    Attributes:
        bundle_count: How many bundles to expect; exact if no image is missing or the bag is truncated.
        warnings: What a person should know about the recording; grows while it is read.
    """

    def __init__(self, path: Path | str, rig: Rig) -> None:
        self.path = Path(path)
        self.rig = rig
        self.bundle_count = 0
        self.warnings: list[str] = []

    def __enter__(self) -> Recording:
        """Open and check the recording.

        Raises:
            InputError: No recording, none of its kind, or one that does not fit the rig.
        """
        self._bag = Bag(self.path)
        try:
            self._check()
        except InputError as error:
            self._bag.close()
            raise type(error)(f"{self.path}: {error}") from None
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._bag.close()

    def bundles(self) -> Iterator[FrameBundle]:
        """Yield the bundles in strictly increasing order of stamps.

        Raises:
            InputError: Images whose size the rig does not state, or nothing readable at all.
        """
        bundler: Bundler[BagMessage] = Bundler(self._period_ns, self.rig.reference)
        undecodable: Counter[str] = Counter()
        count, stamp_ns = 0, 0
        for stamp_ns, members in bundler.groups(self._stamped_images()):
            if images := self._decode(members, undecodable):
                count += 1
                yield FrameBundle(stamp_ns, images)
        for camera, lost in undecodable.items():
            self._warn(f"camera {camera!r}: {_images(lost)} cannot be decoded, left out")
        if bundler.late_count:
            self._warn(f"{_images(bundler.late_count)} came too late to be put in order, left out")
        if bundler.repeated_count:
            self._warn(
                f"{_images(bundler.repeated_count)} with a stamp its camera had already given, left out"
            )
        if self._bag.break_reason and not self._break_told:
            self._warn_of_break(count, stamp_ns)

    def _check(self) -> None:
        self._topics = find_camera_topics(self._bag, self.rig)
        self._period_ns, warnings = look_ahead(self._bag, self._topics, self.rig)
        self.warnings.extend(warnings)
        self.bundle_count = max(self._bag.message_counts.get(topic, 0) for topic in self._topics.images)
        for topic, camera in self._topics.images.items():
            if not self._bag.message_counts.get(topic, 0):
                self._warn(f"camera {camera!r}: no image in the whole recording")
        self._break_told = self._bag.break_reason is not None
        if self._break_told:  # count what is before the break by the stamps alone
            bundler: Bundler[BagMessage] = Bundler(self._period_ns, self.rig.reference)
            stamps_ns = [stamp_ns for stamp_ns, _ in bundler.groups(self._stamped_images())]
            self.bundle_count = len(stamps_ns)
            self._warn_of_break(len(stamps_ns), stamps_ns[-1])

    def _stamped_images(self) -> Iterator[Stamped[BagMessage]]:
        for message in self._bag.messages(self._topics.images.keys()):
            yield Stamped(message.header_stamp_ns, self._topics.images[message.topic], message)

    def _decode(self, members: Sequence[Stamped[BagMessage]], undecodable: Counter[str]) -> dict[str, Image]:
        images: dict[str, Image] = {}
        for member in members:
            try:
                images[member.camera] = read_image(member.payload, self.rig[member.camera].camera)
            except ImageSizeError as error:
                raise InputError(f"{self.path}: {error}") from None
            except InputError:
                undecodable[member.camera] += 1
        return {camera: images[camera] for camera in self.rig.cameras if camera in images}

    def _warn_of_break(self, count: int, stamp_ns: int) -> None:
        self._warn(
            f"{self.path} is {self._bag.break_reason}; used {count} bundles up to {stamp_ns / 1e9:.3f} s"
        )

    def _warn(self, text: str) -> None:
        if text not in self.warnings:
            self.warnings.append(text)


def _images(count: int) -> str:
    return "1 image" if count == 1 else f"{count} images"
