"""Defocus: every point becomes a disc, as large everywhere."""

from __future__ import annotations

import cv2
import numpy as np

from sim.sensing.face import GreyImage

_RADIUS_PX = (0.0, 0.7, 1.3, 2.1, 3.1, 4.4)  # of the disc, by severity
_FINE = 8  # subdivisions of a pixel, so that discs of any radius grow smoothly


def disc_kernel(severity: float) -> GreyImage:
    """Return the (n, n) kernel of a disc, n odd; its sum is 1."""
    radius_px = float(np.interp(severity, range(6), _RADIUS_PX))
    reach = int(np.ceil(radius_px - 0.5)) if radius_px > 0.5 else 0
    n = 2 * reach + 1
    at_px = (np.arange(n * _FINE) + 0.5) / _FINE - n / 2
    inside = (np.hypot(at_px, at_px[:, None]) <= max(radius_px, 0.5)).astype(np.float32)
    kernel = inside.reshape(n, _FINE, n, _FINE).mean((1, 3))
    return np.asarray(kernel / kernel.sum())


def defocus(light: GreyImage, kernel: GreyImage) -> GreyImage:
    """Return (H, W) light blurred by a kernel."""
    return np.asarray(cv2.filter2D(light, -1, kernel, borderType=cv2.BORDER_REFLECT_101))
