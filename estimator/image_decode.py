"""ROS images to grey uint8 arrays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt

from estimator.bundle import Image
from estimator.errors import InputError

_Convert = Callable[[npt.NDArray[Any]], npt.NDArray[Any]]


def _to_grey(code: int) -> _Convert:
    return lambda image: cv2.cvtColor(image, code)


def _keep(image: npt.NDArray[Any]) -> npt.NDArray[Any]:
    return image


def _high_byte(image: npt.NDArray[Any]) -> npt.NDArray[Any]:
    return (image >> 8).astype(np.uint8)


_ENCODINGS: dict[str, tuple[int, int, _Convert]] = {  # channels, bytes a channel, conversion
    "mono8": (1, 1, _keep),
    "8uc1": (1, 1, _keep),
    "bgr8": (3, 1, _to_grey(cv2.COLOR_BGR2GRAY)),
    "8uc3": (3, 1, _to_grey(cv2.COLOR_BGR2GRAY)),
    "rgb8": (3, 1, _to_grey(cv2.COLOR_RGB2GRAY)),
    "bgra8": (4, 1, _to_grey(cv2.COLOR_BGRA2GRAY)),
    "rgba8": (4, 1, _to_grey(cv2.COLOR_RGBA2GRAY)),
    "mono16": (1, 2, _high_byte),
    "16uc1": (1, 2, _high_byte),
}


def decode_image(message: Any) -> Image:
    """Return the (H, W) grey image of a sensor_msgs/Image; rows may be padded to ``step``.

    Raises:
        InputError: An encoding that is not known, or fewer bytes than the header promises.
    """
    encoding = message.encoding.lower()
    if encoding not in _ENCODINGS:
        raise InputError(f"got encoding {message.encoding!r}, wanted one of {', '.join(_ENCODINGS)}")
    channels, width_bytes, convert = _ENCODINGS[encoding]
    row_bytes = message.width * channels * width_bytes
    step = max(message.step, row_bytes)
    needed = step * (message.height - 1) + row_bytes
    if message.width == 0 or message.height == 0 or message.data.size < needed:
        size = f"{message.width} x {message.height}"
        raise InputError(f"got {message.data.size} bytes for {size} pixels of {encoding}, wanted {needed}")
    rows = np.lib.stride_tricks.as_strided(message.data, (message.height, row_bytes), (step, 1))
    pixels = np.ascontiguousarray(rows)
    if width_bytes == 2:
        pixels = pixels.view(">u2" if message.is_bigendian else "<u2")
    if channels > 1:
        pixels = pixels.reshape(message.height, message.width, channels)
    return np.asarray(convert(pixels), np.uint8)


def decode_compressed(message: Any) -> Image:
    """Return the (H, W) grey image of a sensor_msgs/CompressedImage (JPEG, PNG, whatever OpenCV reads).

    Raises:
        InputError: OpenCV cannot read it.
    """
    flags = cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION  # pixels as the sensor gave them
    try:
        image = cv2.imdecode(message.data, flags) if message.data.size else None
    except cv2.error:
        image = None
    if image is None:
        raise InputError(f"got {message.data.size} bytes of format {message.format!r}, wanted JPEG or PNG")
    return np.asarray(image, np.uint8)
