"""Whatever comes in: never an exception, never a number that is none, never a confident wrong answer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from estimator.batch import BatchConfig, BatchEstimator
from estimator.bundle import FrameBundle, Image
from estimator.estimate import Estimate, Status
from estimator.finding import FindingKind
from estimator.online import OnlineEstimator
from estimator.rig import Rig, RigPrior
from estimator.se3 import SE3
from tests.canyon_drive import IN_STEP, NOMINAL, PERIOD_NS, TRUTH

NAMES = tuple(TRUTH.cameras)
SHAPE = (200, 320)
CHI2_95 = 12.59  # six degrees of freedom
Bundles = list[FrameBundle]


def feed(bundles: Sequence[FrameBundle], rig: Rig = NOMINAL, *, batch: bool = False) -> list[Estimate]:
    """Return all answers, checked."""
    estimator = BatchEstimator(rig, BatchConfig(online=IN_STEP)) if batch else OnlineEstimator(rig, IN_STEP)
    answers = [*(estimator.update(bundle) for bundle in bundles), estimator.close()]
    for answer in answers:
        check(answer)
    return answers


def check(answer: Estimate) -> None:
    """Refuse what is no number or no covariance, and certainty that is wrong."""
    for _, pose in answer.trajectory:
        assert np.isfinite(pose.matrix).all()
    for name in set(TRUTH.estimated_names) & set(answer.cameras):
        camera = answer.cameras[name]
        assert np.isfinite(camera.ego_from_cam.matrix).all() and np.isfinite(camera.covariance).all()
        least, most = np.linalg.eigvalsh(0.5 * (camera.covariance + camera.covariance.T))[[0, -1]]
        assert least >= -1e-9 * most
        if camera.status is Status.CONVERGED:
            error = camera.ego_from_cam.local(TRUTH[name].ego_from_cam)
            assert error @ np.linalg.solve(camera.covariance, error) < CHI2_95, name


def kinds(answers: Sequence[Estimate]) -> set[tuple[FindingKind, tuple[str, ...]]]:
    """Return everything that was ever found."""
    return {(finding.kind, finding.cameras) for answer in answers for finding in answer.findings}


def level(grey: int) -> Image:
    return np.full(SHAPE, grey, np.uint8)


def noise(seed: int) -> Image:
    return np.random.default_rng(seed).integers(0, 256, SHAPE, dtype=np.uint8)


def with_images(bundles: Bundles, change: dict[str, Image | None], frames: Sequence[int]) -> Bundles:
    """Return the bundles with some cameras' images replaced, or left out, at some frames."""
    return [
        FrameBundle(
            bundle.stamp_ns,
            {name: image for name, image in (dict(bundle.images) | change).items() if image is not None},
        )
        if index in frames
        else bundle
        for index, bundle in enumerate(bundles)
    ]


@pytest.mark.parametrize("grey", [0, 255])
@pytest.mark.parametrize("batch", [False, True])
def test_images_that_show_nothing_are_named_and_teach_nothing(grey: int, batch: bool) -> None:
    blind = [FrameBundle(k * PERIOD_NS, dict.fromkeys(NAMES, level(grey))) for k in range(15)]
    last = feed(blind, batch=batch)[-1]
    assert {(FindingKind.NO_TEXTURE, (name,)) for name in NAMES} <= kinds([last])
    assert "nothing can be calibrated" in next(f.about for f in last.findings if f.cameras == ("front",))
    assert last.cameras["left_rear"].status is Status.INITIALISING


def test_pure_noise_teaches_nothing() -> None:
    storm = [
        FrameBundle(k * PERIOD_NS, {name: noise(3 * k + c) for c, name in enumerate(NAMES)})
        for k in range(108)
    ]
    last = feed(storm)[-1]
    assert last.cameras["left_rear"].status is not Status.CONVERGED
    assert (FindingKind.UNEXPLAINED_IMAGES, ("front",)) in kinds([last])


def test_noise_in_one_camera_leaves_the_others_as_good(bundles: Bundles) -> None:
    struck = [
        FrameBundle(bundle.stamp_ns, {**bundle.images, "left_rear": noise(k)})
        for k, bundle in enumerate(bundles)
    ]
    last = feed(struck)[-1]
    assert last.cameras["left_rear"].status is Status.LOST
    assert last.cameras["left_front"].status is not Status.LOST
    assert kinds([last]) == {(FindingKind.UNEXPLAINED_IMAGES, ("left_rear",))}


def test_a_camera_out_of_step_is_the_only_one_told_and_the_others_are_as_good(bundles: Bundles) -> None:
    late_ns = 4 * PERIOD_NS // 10
    apart = [
        each
        for b in bundles
        for each in (
            FrameBundle(b.stamp_ns, {n: image for n, image in b.images.items() if n != "left_rear"}),
            FrameBundle(b.stamp_ns + late_ns, {"left_rear": b.images["left_rear"]}),
        )
    ]
    answers = feed(apart)
    assert (FindingKind.CLOCK_OFFSET, ("left_rear",)) in kinds(answers[-1:])
    assert {cameras for _, cameras in kinds(answers)} == {("left_rear",)}
    wanted = feed(bundles)[-1].cameras["left_front"].status
    assert answers[-1].cameras["left_front"].status is wanted is Status.CONVERGED
    assert answers[-1].cameras["left_rear"].status in (Status.LOST, Status.SUSPECT)


@pytest.mark.parametrize("begin", [0, 10])
def test_images_that_all_repeat_to_the_byte_may_be_a_stand_or_a_hanging_recorder(
    bundles: Bundles, begin: int
) -> None:
    last_ns = bundles[begin].stamp_ns
    hung = [FrameBundle(last_ns + k * PERIOD_NS, bundles[begin].images) for k in range(1, 40)]
    answers = feed([*bundles[: begin + 1], *hung])
    (finding,) = answers[-1].findings
    assert finding.kind is FindingKind.NO_MOTION
    assert "the car stands" in finding.about and "hangs" in finding.about


def test_a_frozen_camera_is_named(bundles: Bundles) -> None:
    frozen = with_images(bundles, {"left_rear": bundles[2].images["left_rear"]}, range(3, 20))[:14]
    answers = feed(frozen)
    assert (FindingKind.FROZEN_IMAGE, ("left_rear",)) in kinds(answers)
    assert answers[-1].cameras["left_rear"].status is Status.LOST


def test_a_frozen_reference_is_named_and_nothing_is_claimed(bundles: Bundles) -> None:
    answers = feed(with_images(bundles, {"front": bundles[0].images["front"]}, range(20)))
    assert (FindingKind.FROZEN_IMAGE, ("front",)) in kinds(answers)
    assert answers[-1].cameras["left_rear"].status is Status.INITIALISING


def test_a_missing_reference_is_named(bundles: Bundles) -> None:
    answers = feed(with_images(bundles, {"front": None}, range(2, 20)))
    assert (FindingKind.NO_IMAGE, ("front",)) in kinds(answers)
    assert answers[-1].cameras["left_rear"].status is Status.INITIALISING


def test_a_reference_that_comes_and_goes_is_survived(bundles: Bundles) -> None:
    feed(with_images(bundles[:14], {"front": None}, [*range(4, 8), 10]))


@pytest.mark.parametrize("only", [("front",), ("left_rear",), ()])
def test_few_cameras_or_none(bundles: Bundles, only: tuple[str, ...]) -> None:
    missing: dict[str, Image | None] = dict.fromkeys(set(NAMES) - set(only))
    last = feed(with_images(bundles, missing, range(20)))[-1]
    assert {(FindingKind.NO_IMAGE, (name,)) for name in missing} <= kinds([last])
    assert last.cameras["left_rear"].status is not Status.CONVERGED


def test_images_of_another_size_or_kind_are_left_out_and_named(bundles: Bundles) -> None:
    small, colour = level(9)[::2, ::2], np.zeros((*SHAPE, 3), np.uint8)
    odd = with_images(
        bundles[:15], {"left_front": small, "left_rear": colour, "roof": level(9)}, range(4, 15)
    )
    last = feed(odd)[-1]
    about = " ".join(finding.about for finding in last.findings)
    assert "got uint8 160 x 100, wanted uint8 320 x 200" in about
    assert kinds([last]) >= {(FindingKind.NO_IMAGE, (n,)) for n in ("left_front", "left_rear")}


def test_swapped_cables_are_named_and_never_called_converged(bundles: Bundles) -> None:
    swapped = [
        FrameBundle(
            b.stamp_ns,
            {**b.images, "left_front": b.images["left_rear"], "left_rear": b.images["left_front"]},
        )
        for b in bundles[:12]
    ]
    answers = feed(swapped, batch=True)  # while it drives, the answers are the online estimator's
    assert (FindingKind.SWAPPED_CAMERAS, ("left_front", "left_rear")) in kinds(answers[-1:])
    for name in ("left_front", "left_rear"):
        assert all(answer.cameras[name].status is not Status.CONVERGED for answer in answers)


def test_a_minute_of_standing_changes_nothing_and_ends(bundles: Bundles) -> None:
    rng = np.random.default_rng(0)
    sooty = {n: np.clip(i + rng.normal(0, 2, i.shape), 0, 255) for n, i in bundles[10].images.items()}
    images = [
        {n: np.clip(i + rng.normal(0, 1, i.shape), 0, 255).astype(np.uint8) for n, i in sooty.items()}
        for _ in range(5)
    ]
    start = bundles[10].stamp_ns
    still = [FrameBundle(start + k * PERIOD_NS, images[k % 5]) for k in range(1, 601)]
    after = [FrameBundle(bundle.stamp_ns + 600 * PERIOD_NS, bundle.images) for bundle in bundles[11:]]
    answers = feed([*bundles[:11], *still, *after])
    before, standing, last = answers[10], answers[610], answers[-1]
    assert (FindingKind.NO_MOTION, ("front",)) in kinds([standing])
    assert (FindingKind.NO_MOTION, ("front",)) not in kinds([last])
    for name in TRUTH.estimated_names:
        np.testing.assert_array_equal(
            standing.cameras[name].ego_from_cam.matrix, before.cameras[name].ego_from_cam.matrix
        )
    assert last.cameras["left_rear"].status is Status.CONVERGED


def test_reversing_is_as_good_as_driving(bundles: Bundles) -> None:
    back = [FrameBundle(k * PERIOD_NS, b.images) for k, b in enumerate(reversed(bundles))]
    last = feed(back)[-1]
    assert last.cameras["left_front"].status is Status.CONVERGED
    assert not last.findings


def test_gaps_repeats_and_steps_back_in_time_are_survived(bundles: Bundles) -> None:
    stamps = [0, 1, 2, 2, 3, 1, 4, 90, 91, 92, 93, 94, 95, 96, 97, 10**6, 10**6 + 1, 10**6 + 2, 5, 10**6 + 3]
    odd = [FrameBundle(s * PERIOD_NS, b.images) for s, b in zip(stamps, bundles, strict=True)]
    last = feed(odd)[-1]
    given = [stamp for stamp, _ in last.trajectory]
    assert given == sorted(set(given))


def turned(degrees: float, axis: tuple[int, int, int], names: Sequence[str]) -> Rig:
    """Return the nominal rig with cameras turned about an axis of the car."""
    turn = SE3.exp(np.array([*(np.deg2rad(degrees) * np.array(axis)), 0, 0, 0]))
    poses = {n: NOMINAL[n].ego_from_cam for n in names}
    return NOMINAL.with_extrinsics(
        {n: SE3(turn.rotation @ pose.rotation, pose.translation) for n, pose in poses.items()}
    )


def at_height(metres: float) -> Rig:
    pose = NOMINAL["front"].ego_from_cam
    moved = SE3(pose.rotation, np.array([*pose.translation[:2], metres]))
    return NOMINAL.with_extrinsics({"front": moved})


NONSENSE = {
    "underground": at_height(-1.0),
    "on the road": at_height(0.0),
    "on a mast": at_height(15.0),
    "at one point": NOMINAL.with_extrinsics(
        {
            n: SE3(m.ego_from_cam.rotation, NOMINAL["front"].ego_from_cam.translation)
            for n, m in NOMINAL.cameras.items()
        }
    ),
    "one camera by 90": turned(90, (0, 0, 1), ["left_rear"]),
    "one camera by 180": turned(180, (0, 0, 1), ["left_front"]),
    "one camera upside down": turned(180, (1, 0, 0), ["left_front"]),
    "reference by 90": turned(90, (0, 0, 1), ["front"]),
    "reference by 180": turned(180, (0, 0, 1), ["front"]),
    "reference on its side": turned(90, (1, 0, 0), ["front"]),
    "reference at the ground": turned(90, (0, 1, 0), ["front"]),
    "no prior": replace(NOMINAL, prior=RigPrior(0.0, 0.0)),
    "any prior": replace(NOMINAL, prior=RigPrior(1e6, 1e9)),
    "alone": Rig("front", {"front": NOMINAL["front"]}),
}


REJECTED, UNEXPLAINED = FindingKind.NOMINAL_REJECTED, FindingKind.UNEXPLAINED_IMAGES
SAID: dict[str, set[tuple[FindingKind, tuple[str, ...]]]] = {  # an empty set: nothing at all
    "underground": {(REJECTED, ("front",))},
    "on the road": {(REJECTED, ("front",))},
    "on a mast": set(),  # the car seems to fly, which is no contradiction: the others stay weak
    "at one point": {(REJECTED, ("left_front",)), (REJECTED, ("left_rear",))},
    "one camera by 90": {(UNEXPLAINED, ("left_rear",))},
    "one camera by 180": {(UNEXPLAINED, ("left_front",))},
    "one camera upside down": set(),  # it is weak: in one window nothing tells
    "reference by 90": {(REJECTED, ("front",))},
    "reference by 180": {(REJECTED, ("front",))},
    "reference on its side": set(),  # the car hardly seems to move, so no window is full yet
    "reference at the ground": set(),
    "no prior": {(REJECTED, ("left_front",)), (REJECTED, ("left_rear",))},
    "any prior": set(),  # the drive itself finds the rig
    "alone": set(),
}


@pytest.mark.parametrize("name", NONSENSE)
def test_nonsense_poses_are_never_confidently_kept_and_what_can_be_told_is(
    bundles: Bundles, name: str
) -> None:
    needed = 20 if name == "at one point" else 12  # a camera off by 2 deg only is sure after two windows
    found = kinds(feed(bundles[:needed], NONSENSE[name])[-1:])
    assert SAID[name] <= found
    assert SAID[name] or not found
