"""A sheet holds every scenario's images, name and sentence."""

import numpy as np

from eval.contact_sheet import draw_sheet
from eval.glimpse import Glimpse, _at_size, telling_cameras
from scenarios.load import load_scenario

CAMERAS = ("front", "left_front", "rear")


def glimpse(level: int, about: str = "A sentence.", missing: str = "") -> Glimpse:
    images = {name: np.full((400, 640), level, np.uint8) for name in CAMERAS if name != missing}
    return Glimpse(f"level_{level}", about, images, CAMERAS)


def test_every_scenario_is_on_the_sheet() -> None:
    sheet = draw_sheet([glimpse(level) for level in (100, 120, 140, 160, 180)])
    for level in (100, 120, 140, 160, 180):
        shown = (sheet == level).all(axis=2).sum()
        assert shown >= 352 * 220 + 2 * 174 * 108


def test_a_camera_without_image_is_a_dark_tile() -> None:
    whole, lacking = (draw_sheet([glimpse(150, missing=missing)]) for missing in ("", "rear"))
    assert (whole != lacking).any(axis=2).sum() == 174 * 108


def test_a_long_sentence_is_cut_to_its_place() -> None:
    short, long = (draw_sheet([glimpse(150, about)]) for about in ("Short.", "word " * 200))
    assert short.shape == long.shape and (long < 200).sum() > (short < 200).sum()


def test_three_cameras_tell_most_and_those_that_something_happens_to_come_before_others() -> None:
    assert telling_cameras(load_scenario("first_drive")) == CAMERAS
    assert telling_cameras(load_scenario("knock"))[1] == "right_rear"
    assert telling_cameras(load_scenario("wrong_intrinsics"))[1] == "right_front"


def test_an_image_of_too_few_pixels_looks_smaller() -> None:
    half = _at_size(np.full((200, 320), 7, np.uint8), 640)
    assert half.shape == (400, 640) and (half[:200, :320] == 7).all() and (half == 7).mean() == 0.25
    whole = np.full((400, 640), 7, np.uint8)
    assert _at_size(whole, 640) is whole
