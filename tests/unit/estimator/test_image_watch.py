"""Spells of missing, blind and frozen images."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from estimator.bundle import FrameBundle, Image
from estimator.finding import Finding, FindingKind
from estimator.image_watch import ImageWatch, ImageWatchConfig
from estimator.repeats import Repeats
from tests.canyon import noise_image
from tests.mounts import left_side_rig

RIG = left_side_rig()
NAMES = tuple(RIG.cameras)
MANY = dict.fromkeys(NAMES, 100)
BEGINS, ENDS = ImageWatchConfig().begins_after, ImageWatchConfig().ends_after


def scene(seed: int) -> Image:
    return noise_image(200, 320, seed)


class Drive:
    """Feeds bundles, each with new pictures unless told otherwise, and remembers how many there were."""

    def __init__(self) -> None:
        self.watch = ImageWatch(RIG, ImageWatchConfig())
        self._repeats = Repeats()
        self._count = 0

    def see(
        self, times: int, other: Mapping[str, Image | None], corners: Mapping[str, int] = MANY
    ) -> list[Finding]:
        for _ in range(times):
            self._count += 1
            images = {name: scene(self._count % 7) for name in NAMES} | dict(other)
            given = {name: image for name, image in images.items() if image is not None}
            usable = self.watch.usable(FrameBundle(self._count, given))
            self._repeats.see(usable)
            self.watch.see(usable, corners, self._repeats.names)
        return list(self.watch.findings())


def test_sound_images_give_no_finding() -> None:
    assert Drive().see(3 * BEGINS, {}) == []


def test_a_missing_image_is_a_finding_only_after_a_while_and_ends_with_images() -> None:
    drive = Drive()
    assert drive.see(BEGINS - 1, {"left_rear": None}) == []
    (finding,) = drive.see(1, {"left_rear": None})
    assert (finding.kind, finding.cameras) == (FindingKind.NO_IMAGE, ("left_rear",))
    assert not finding.doubtful
    assert drive.see(ENDS - 1, {}) != []
    assert drive.see(1, {}) == []


@pytest.mark.parametrize("grey", [0, 250])
def test_an_image_of_one_level_without_corners_shows_nothing(grey: int) -> None:
    flat = np.full((200, 320), grey, np.uint8)
    (finding,) = Drive().see(BEGINS, {"front": flat}, MANY | {"front": 0})
    assert (finding.kind, finding.cameras) == (FindingKind.NO_TEXTURE, ("front",))
    assert f"level {grey}" in finding.about and "nothing can be calibrated" in finding.about


def test_a_dark_image_with_corners_shows_something() -> None:
    flat = np.full((200, 320), 3, np.uint8)
    assert Drive().see(BEGINS, {"front": flat}) == []


def test_one_image_again_and_again_is_frozen_while_others_move() -> None:
    still = scene(99)
    (finding,) = Drive().see(BEGINS + 1, {"left_rear": still})
    assert (finding.kind, finding.cameras) == (FindingKind.FROZEN_IMAGE, ("left_rear",))


def test_a_world_in_which_nothing_moves_is_not_frozen() -> None:
    assert Drive().see(BEGINS + 5, dict.fromkeys(NAMES, scene(99))) == []


@pytest.mark.parametrize(
    ("odd", "got"),
    [
        (np.zeros((100, 160), np.uint8), "uint8 160 x 100"),
        (np.zeros((200, 320, 3), np.uint8), "uint8 3 x 320 x 200"),
        (np.zeros((200, 320)), "float64 320 x 200"),
    ],
)
def test_what_is_no_image_of_the_rig_is_left_out_and_named(odd: Image, got: str) -> None:
    (finding,) = Drive().see(BEGINS, {"left_front": odd, "roof": scene(0)})
    assert finding.kind is FindingKind.NO_IMAGE and got in finding.about


def test_black_frames_now_and_then_are_no_finding() -> None:
    drive, flat = Drive(), np.zeros((200, 320), np.uint8)
    for _ in range(BEGINS):
        drive.see(2, {"front": flat}, MANY | {"front": 0})
        assert drive.see(ENDS, {}) == []


@pytest.mark.parametrize("seed", range(20))
def test_images_lost_at_random_are_no_finding(seed: int) -> None:
    drive, rng = Drive(), np.random.default_rng(seed)
    for _ in range(100):
        lost = {name: None for name in NAMES if rng.random() < 0.3}
        assert drive.see(1, lost) == []


def test_a_spell_counts_only_the_bundles_without_an_image() -> None:
    drive = Drive()
    drive.see(BEGINS - 2, {"left_rear": None})
    drive.see(1, {})
    drive.see(BEGINS, {"left_rear": None})
    drive.see(ENDS - 1, {})
    (finding,) = drive.see(1, {"left_rear": None})
    assert f"for {BEGINS + 1} bundles" in finding.about
