from __future__ import annotations

import numpy as np
import pytest

from estimator.camera import Camera
from estimator.errors import InputError
from sim.sensing.lens import make_lens

BROWN = Camera(
    "brown_conrady", (320, 200), (180.0, 182.0), (155.2, 101.7), (-0.2, 0.05, 0.0004, -0.0003, 0.002)
)
FISHEYE = Camera("kannala_brandt", (320, 200), (200.0, 200.0), (160.3, 99.1), (-0.012, 0.004, -0.002, 0.0003))


@pytest.mark.parametrize("camera", [BROWN, FISHEYE], ids=lambda camera: camera.model)
def test_every_sample_comes_from_where_its_ray_meets_the_source(camera: Camera) -> None:
    lens = make_lens(camera)
    assert lens.map_xy is not None
    assert lens.source.contains(lens.map_xy.reshape(-1, 2), margin_px=1).all()
    means = lens.map_xy.reshape(200, 2, 320, 2, 2).mean((1, 3)).reshape(-1, 2)[::37]
    columns, rows = np.meshgrid(np.arange(320.0), np.arange(200.0))
    pixels = np.stack([columns, rows], -1).reshape(-1, 2)[::37]
    assert np.abs(lens.source.project(camera.unproject(pixels)) - means).max() < 0.003


def test_a_pinhole_is_rendered_as_it_is() -> None:
    camera = Camera("pinhole", (320, 200), (200.0, 190.0), (150.0, 99.1))
    light = np.random.default_rng(0).random((200, 320), np.float32)
    lens = make_lens(camera)
    assert lens.source == camera
    assert lens.apply(light) is light


def test_a_field_too_wide_for_a_flat_source_is_refused() -> None:
    wide = Camera("kannala_brandt", (320, 200), (100.0, 100.0), (160.0, 100.0), (0.0, 0.0, 0.0, 0.0))
    with pytest.raises(InputError, match=r"kannala_brandt camera sees 10\d deg off its axis"):
        make_lens(wide)
