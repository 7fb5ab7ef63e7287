"""All cameras in one picture, laid out as on the car."""

import numpy as np
import pytest

from eval.lettering import text_width_px, wrapped
from eval.mosaic import Mosaic, rows_of
from scenarios.load import load_scenario

RIG = load_scenario("first_drive").rig
ROWS = (("left_front", "front", "front_right", "right_front"), ("left_rear", "rear", "right_rear"))


def test_cameras_lie_as_they_look_from_left_to_right() -> None:
    assert rows_of(RIG) == ROWS


def test_a_picture_shows_every_image_and_marks_missing_and_stale_ones() -> None:
    mosaic = Mosaic(ROWS)
    bright = {name: np.full((400, 640), 200, np.uint8) for name in RIG.cameras if name != "rear"}
    picture = mosaic.compose(bright, frozenset({"front"}), "title")
    width, height = mosaic.size_px
    assert picture.shape == (height, width, 3) and width % 2 == height % 2 == 0
    middles = [picture[190, 250], picture[190, 730], picture[500, width // 2]]
    assert [int(middle.mean()) for middle in middles] == [200, 66, 22]


def test_images_of_any_size_are_fitted_without_distortion() -> None:
    picture = Mosaic((("front",),)).compose({"front": np.full((40, 40), 255, np.uint8)}, frozenset(), "")
    lit = (picture.min(axis=2) > 200).sum()
    assert lit == pytest.approx(300 * 300, rel=0.02)


def test_text_is_wrapped_to_its_width() -> None:
    lines = wrapped("one two three four five six seven", 20, 120)
    assert len(lines) > 1 and " ".join(lines) == "one two three four five six seven"
    assert all(text_width_px(line, 20) <= 120 for line in lines)
