from __future__ import annotations

from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from estimator.camera import Camera, CameraModel
from estimator.errors import InputError
from estimator.rig import MountedCamera, Rig
from estimator.rig_file import read_rig
from estimator.se3 import SE3
from scenarios.load import load_scenario
from sim.sensing.refit import check_lenses, with_lenses

RIGS = Path(__file__).parents[4] / "scenarios" / "rigs"


def half_field_deg(camera: Camera) -> float:
    edges = np.array([[0.0, camera.center_px[1]], [camera.size_px[0] - 1.0, camera.center_px[1]]])
    return float(np.degrees(np.arccos(camera.unproject(edges)[:, 2])).mean())


@pytest.mark.parametrize("model", get_args(CameraModel))
def test_every_camera_gets_the_model_and_keeps_field_size_and_place(model: CameraModel) -> None:
    rig = read_rig(RIGS / "gap.yaml")
    for name, mounted in with_lenses(rig, model).cameras.items():
        assert mounted.camera.model == model
        assert mounted.camera.size_px == rig[name].camera.size_px
        assert mounted.ego_from_cam is rig[name].ego_from_cam
        assert half_field_deg(mounted.camera) == pytest.approx(half_field_deg(rig[name].camera), abs=0.5)


def test_a_fisheye_shrinks_to_what_a_pinhole_can_see() -> None:
    rig = with_lenses(read_rig(RIGS / "fisheye.yaml"), "pinhole")
    assert half_field_deg(rig["rear"].camera) == pytest.approx(60, abs=0.5)
    check_lenses(rig)


def test_the_setting_reaches_the_rig_that_the_estimator_gets() -> None:
    rig = load_scenario("first_drive", ["sensor.lens=kannala_brandt"]).rig
    assert {mounted.camera.model for mounted in rig.cameras.values()} == {"kannala_brandt"}


@pytest.mark.parametrize("name", ["gap", "overlap", "fisheye"])
def test_bundled_rigs_have_lenses_that_can_be_simulated(name: str) -> None:
    check_lenses(read_rig(RIGS / f"{name}.yaml"))


def test_a_lens_that_folds_over_is_refused_by_name() -> None:
    folding = Camera("kannala_brandt", (320, 200), (100.0, 100.0), (160.0, 100.0), (-0.15, 0.0, 0.0, 0.0))
    with pytest.raises(InputError, match=r"cameras\.front: got a kannala_brandt lens that folds over"):
        check_lenses(Rig("front", {"front": MountedCamera(folding, SE3())}))


@pytest.mark.parametrize("size_px", [(40_000, 40), (8000, 8000)])
def test_an_image_too_large_for_memory_is_refused_by_name(size_px: tuple[int, int]) -> None:
    large = Camera("pinhole", size_px, (9e3, 9e3), (size_px[0] / 2, size_px[1] / 2), ())
    with pytest.raises(
        InputError, match=r"cameras\.front\.size_px: got \[\d+, \d+\], wanted at most 8192 a side"
    ):
        check_lenses(Rig("front", {"front": MountedCamera(large, SE3())}))
