"""JPEG: what compressing an image and unpacking it again leaves of it."""

from __future__ import annotations

import cv2
import numpy as np

from estimator.bundle import Image

_QUALITY = (100, 85, 65, 45, 28, 14)  # by severity


def through_jpeg(image: Image, severity: float) -> Image:
    """Return an (H, W) image as it comes out of a JPEG file."""
    quality = round(float(np.interp(severity, range(6), _QUALITY)))
    _, packed = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, quality])
    return np.asarray(cv2.imdecode(packed, cv2.IMREAD_GRAYSCALE))
