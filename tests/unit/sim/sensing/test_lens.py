from __future__ import annotations

import numpy as np
import pytest

from estimator.camera import Camera
from estimator.errors import InputError
from estimator.se3 import Array
from sim.sensing.lens import Lens, make_lens

PINHOLE = Camera("pinhole", (320, 200), (200.0, 190.0), (150.0, 99.1))
BROWN = Camera(
    "brown_conrady", (320, 200), (180.0, 182.0), (155.2, 101.7), (-0.2, 0.05, 0.0004, -0.0003, 0.002)
)
FISHEYE = Camera("kannala_brandt", (320, 200), (200.0, 200.0), (160.3, 99.1), (-0.012, 0.004, -0.002, 0.0003))
WIDE = Camera("kannala_brandt", (320, 200), (96.0, 97.0), (158.3, 101.1), (0.01, -0.003, 0.0005, 0.0))
CAMERAS = [PINHOLE, BROWN, FISHEYE, WIDE]
IDS = ["pinhole", "brown_conrady", "kannala_brandt", "wide"]


def sample_rays(lens: Lens) -> Array:
    """Return (rows, columns, 3) rays in the camera's frame that the faces say the samples follow."""
    width, height = lens.size_px
    n = lens.samples_a_side
    rays = np.full((n * height, n * width, 3), np.nan)
    for face in lens.faces:
        there = face.pinhole.unproject(face.map_xy.reshape(-1, 2)) @ face.cam_from_face.rotation.T
        served = np.ones(face.map_xy.shape[:2], bool) if face.served is None else face.served
        rays[face.block][served] = there.reshape(*face.map_xy.shape[:2], 3)[served]
    return rays


@pytest.mark.parametrize("camera", CAMERAS[1:], ids=IDS[1:])
def test_every_sample_comes_from_where_its_ray_meets_a_source(camera: Camera) -> None:
    lens = make_lens(camera)
    for face in lens.faces:
        used = face.map_xy if face.served is None else face.map_xy[face.served]
        assert face.pinhole.contains(used.reshape(-1, 2), margin_px=1).all()
    columns, rows = ((np.arange(2 * n) + 0.5) / 2 - 0.5 for n in camera.size_px)
    pixels = np.stack(np.meshgrid(columns, rows), -1).reshape(-1, 2)[::37]
    expected = camera.unproject(pixels)
    assert np.abs(sample_rays(lens).reshape(-1, 3)[::37] - expected).max() < 1e-5


def test_a_field_of_more_than_a_half_sphere_takes_several_faces_that_part_it() -> None:
    lens = make_lens(WIDE)
    assert np.degrees(np.arccos(WIDE.unproject(np.array([[0.0, 0.0]]))[0, 2])) > 100
    served = np.zeros((400, 640), int)
    for face in lens.faces:
        assert face.served is not None
        served[face.block] += face.served
    assert len(lens.faces) > 3
    assert (served == 1).all()


@pytest.mark.parametrize("camera", CAMERAS, ids=IDS)
@pytest.mark.parametrize("margin_px", [0, 6])
def test_rows_of_a_lens_look_where_the_whole_lens_does(camera: Camera, margin_px: int) -> None:
    lens = make_lens(camera)
    part = lens.rows(20, 31, margin_px)
    n = lens.samples_a_side
    assert np.allclose(sample_rays(part), sample_rays(lens)[20 * n : 31 * n], atol=2e-5)
    whole_px = sum(np.prod(face.pinhole.size_px) for face in lens.faces)
    assert sum(np.prod(face.pinhole.size_px) for face in part.faces) < 0.35 * whole_px
    largest = np.max([face.pinhole.size_px for face in part.faces], axis=0)
    assert (largest <= lens.largest_px).all()


def test_rows_of_a_pinhole_are_rows_of_its_picture() -> None:
    light = np.random.default_rng(0).random((200, 320), np.float32)
    assert np.array_equal(make_lens(PINHOLE).rows(20, 31).apply([light[20:31]]), light[20:31])


def test_a_pinhole_is_rendered_as_it_is() -> None:
    light = np.random.default_rng(0).random((200, 320), np.float32)
    lens = make_lens(PINHOLE)
    assert lens.source == PINHOLE
    assert lens.apply([light]) is light


@pytest.mark.parametrize("camera", CAMERAS, ids=IDS)
def test_a_row_exposed_later_shows_what_has_moved_there_since(camera: Camera) -> None:
    """A ramp of light that moves right by 40 px/s over the source, exposed row by row."""
    lens = make_lens(camera).rows(90, 110, 6)
    shapes = [face.pinhole.size_px[::-1] for face in lens.faces]
    ramps = [np.tile(np.arange(width, dtype=np.float32), (height, 1)) for height, width in shapes]
    rates = [np.tile(np.array([40.0, 0.0], np.float32), (*shape, 1)) for shape in shapes]
    delay_s = np.linspace(-0.02, 0.02, 20)
    moved = lens.apply(ramps, rates, delay_s)
    still = lens.apply(ramps, rates, np.zeros(20))
    error_px = np.abs(moved - still + 40 * delay_s[:, None])
    assert np.quantile(error_px, 0.99) < 0.04


def test_a_lens_that_folds_over_inside_the_image_is_refused() -> None:
    folding = Camera("kannala_brandt", (320, 200), (100.0, 100.0), (160.0, 100.0), (-0.15, 0.0, 0.0, 0.0))
    with pytest.raises(
        InputError, match=r"kannala_brandt lens that folds over inside the image.*beyond 9\d px"
    ):
        make_lens(folding)
