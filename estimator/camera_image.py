"""The grey image of one camera, checked against the size its rig states."""

from __future__ import annotations

from estimator.bag_message import BagMessage
from estimator.bag_rosbags import parse
from estimator.bundle import Image
from estimator.camera import Camera
from estimator.errors import InputError
from estimator.image_decode import decode_compressed, decode_image


class ImageSizeError(InputError):
    """Images of a size the rig does not state: not to be skipped like a damaged image."""


def read_image(message: BagMessage, camera: Camera) -> Image:
    """Return the (H, W) grey image of an Image or a CompressedImage message.

    Raises:
        ImageSizeError: The image is not of the camera's size.
        InputError: The image cannot be decoded.
    """
    decode = decode_compressed if message.topic.endswith("/compressed") else decode_image
    try:
        image = decode(parse(message))
    except InputError as error:
        raise InputError(f"topic {message.topic}: {error}") from None
    height, width = image.shape
    if (width, height) != tuple(camera.size_px):
        wanted = f"{camera.size_px[0]} x {camera.size_px[1]}"
        raise ImageSizeError(
            f"topic {message.topic}: got images of {width} x {height} pixels, the rig states {wanted}"
        )
    return image
