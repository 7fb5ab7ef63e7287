"""Images come through the true lens; everybody else believes the rig file."""

import pytest

from scenarios.load import load_scenario
from sim.faults.wrong_intrinsics import WrongIntrinsics, with_true_lenses

RIG = load_scenario("first_drive").rig


def test_only_the_named_cameras_have_another_lens() -> None:
    fault = WrongIntrinsics(kind="wrong_intrinsics", camera="rear", focal_percent=2, center_px=[3, -4])
    true = with_true_lenses(RIG, [fault])
    stated, real = RIG["rear"].camera, true["rear"].camera
    assert real.focal_px == pytest.approx([1.02 * focal for focal in stated.focal_px])
    assert real.center_px == pytest.approx([stated.center_px[0] + 3, stated.center_px[1] - 4])
    assert (real.model, real.size_px, real.distortion) == (stated.model, stated.size_px, stated.distortion)
    assert all(true[name] == RIG[name] for name in RIG.cameras if name != "rear")


def test_without_faults_the_rig_is_the_same() -> None:
    assert with_true_lenses(RIG, []) == RIG
