"""Images of messages as grey arrays; whole bags are tried in the integration tests."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from estimator.errors import InputError
from estimator.image_decode import decode_compressed, decode_image
from tests.bag_messages import Frame, compressed_message, image_message

PIXELS = np.arange(12, dtype=np.uint8).reshape(3, 4)
FRAME = Frame("front", 0, PIXELS)


def test_a_step_of_zero_means_no_padding() -> None:
    np.testing.assert_array_equal(decode_image(replace(image_message(FRAME), step=0)), PIXELS)


def test_the_last_row_may_lack_its_padding() -> None:
    message = image_message(FRAME, padding=3)
    np.testing.assert_array_equal(decode_image(replace(message, data=message.data[:-3])), PIXELS)


def test_primary_colours_keep_their_weights() -> None:
    red = Frame("front", 0, np.full((1, 1, 3), (255, 0, 0), np.uint8))
    assert decode_image(image_message(red, "rgb8"))[0, 0] == 76
    assert decode_image(image_message(red, "bgr8"))[0, 0] == 29


def test_encodings_are_read_in_any_case() -> None:
    np.testing.assert_array_equal(decode_image(image_message(FRAME, "8UC1")), PIXELS)


@pytest.mark.parametrize("change", [{"encoding": "yuv422"}, {"width": 0}, {"height": 0}, {"height": 4}])
def test_what_cannot_be_decoded_is_refused(change: dict[str, object]) -> None:
    with pytest.raises(InputError, match=r"got .* wanted"):
        decode_image(replace(image_message(FRAME), **change))


@pytest.mark.parametrize("data", [b"", b"no image", b"\x89PNG\r\n\x1a\n"])
def test_what_is_no_compressed_image_is_refused(data: bytes) -> None:
    message = replace(compressed_message(FRAME), data=np.frombuffer(data, np.uint8))
    with pytest.raises(InputError, match="wanted JPEG or PNG"):
        decode_compressed(message)


def test_a_colour_png_becomes_grey() -> None:
    message = compressed_message(Frame("front", 0, np.full((2, 2, 3), (0, 0, 255), np.uint8)))  # OpenCV: BGR
    np.testing.assert_array_equal(decode_compressed(message), np.full((2, 2), 76))
