"""Landmarks of one camera, found by the others."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.anchors import choose_anchors
from estimator.bundle import Image
from estimator.handover import HandoverConfig, hand_over
from estimator.observations import Observations
from estimator.scene import Scene
from tests.canyon import noise_image
from tests.canyon_window import look
from tests.mounts import arc, left_side_rig, shaken

CONFIG = HandoverConfig()
WINDOW = look(left_side_rig(), arc(1.2, 5), ("front", "left_front"), 100)
NOT_ROAD = np.zeros(len(WINDOW.normals_world), bool)
FRONT, LEFT_FRONT, LEFT_REAR = range(3)


def handed_over(
    scene: Scene = WINDOW.scene,
    images: list[list[Image | None]] = WINDOW.images,
    radius_px: float = 4.0,
    config: HandoverConfig = CONFIG,
) -> Observations:
    anchors = choose_anchors(scene, WINDOW.observations, WINDOW.images, NOT_ROAD)
    return hand_over(scene, images, WINDOW.observations, anchors, np.full(3, radius_px), config)


FOUND = handed_over()


def error_px(found: Observations) -> np.ndarray:
    true_px = WINDOW.true_px(found.landmark, found.camera, found.keyframe)
    return np.linalg.norm(found.pixels - true_px, axis=1)


def test_another_camera_finds_landmarks_where_they_are() -> None:
    by_left_front = FOUND.select(FOUND.camera == LEFT_FRONT)
    assert len(by_left_front) > 10
    assert np.median(error_px(by_left_front)) < 0.15
    assert np.mean(error_px(FOUND) < 1.0) > 0.95


def test_the_rear_group_finds_later_what_the_front_group_saw() -> None:
    by_left_rear = FOUND.select(FOUND.camera == LEFT_REAR)
    assert len(by_left_rear) > 10
    assert by_left_rear.keyframe.min() > 1


def test_they_count_as_handed_over_and_no_camera_finds_its_own() -> None:
    owner = np.full(len(WINDOW.scene.points_world), -1)
    owner[WINDOW.observations.landmark] = WINDOW.observations.camera
    assert FOUND.handed_over.all() and (FOUND.sigma_px == CONFIG.sigma_px).all()
    assert (owner[FOUND.landmark] != FOUND.camera).all()


def test_a_camera_seeks_a_landmark_in_a_few_pictures_only() -> None:
    few = handed_over(config=HandoverConfig(views_per_camera=1))
    _, count = np.unique(few.landmark * 3 + few.camera, return_counts=True)
    assert len(few) > 10 and count.max() == 1


def test_a_camera_that_is_off_still_finds_them_with_a_wider_search() -> None:
    off = replace(WINDOW.scene, rig=shaken(WINDOW.scene.rig, 3.0, 20.0))
    narrow, wide = handed_over(off, radius_px=3.0), handed_over(off, radius_px=12.0)
    narrow, wide = (found.select(found.camera != FRONT) for found in (narrow, wide))
    assert np.sum(error_px(wide) < 1.0) > 1.5 * np.sum(error_px(narrow) < 1.0)
    assert np.mean(error_px(wide) < 1.0) > 0.7


def test_a_camera_that_looks_elsewhere_finds_nothing() -> None:
    away = left_side_rig()
    turned = away["left_front"].ego_from_cam.retract(np.array([0.0, 3.1, 0.0, 0.0, 0.0, 0.0]))
    away = away.with_extrinsics({"left_front": turned, "left_rear": turned})
    found = handed_over(replace(WINDOW.scene, rig=away))
    assert not (found.camera == LEFT_REAR).any()


def test_another_street_in_the_picture_is_not_taken_for_this_one() -> None:
    images: list[list[Image | None]] = [
        [row[FRONT], noise_image(200, 320, 50 + index), noise_image(200, 320, 90 + index)]
        for index, row in enumerate(WINDOW.images)
    ]
    anchors = choose_anchors(WINDOW.scene, WINDOW.observations, WINDOW.images, NOT_ROAD)
    anchors.valid[anchors.camera != FRONT] = False
    found = hand_over(WINDOW.scene, images, WINDOW.observations, anchors, np.full(3, 4.0), CONFIG)
    assert len(found) <= 0.02 * len(FOUND)


def test_of_two_places_that_look_alike_neither_is_taken() -> None:
    keyframe, (u, v) = int(FOUND.keyframe[0]), FOUND.pixels[0].round().astype(int)
    camera, landmark = int(FOUND.camera[0]), int(FOUND.landmark[0])
    images = [list(row) for row in WINDOW.images]
    twice = WINDOW.images[keyframe][camera].copy()
    side = 24 if u < 160 else -24
    twice[v - 11 : v + 12, u + side - 11 : u + side + 12] = twice[v - 11 : v + 12, u - 11 : u + 12]
    images[keyframe][camera] = twice
    for given, wanted in ((WINDOW.images, True), (images, False)):
        found = handed_over(images=given, radius_px=28.0)
        rows = (found.landmark == landmark) & (found.camera == camera) & (found.keyframe == keyframe)
        assert rows.any() == wanted


def test_missing_pictures_are_passed_over() -> None:
    images = [[*row[:LEFT_REAR], None] if index != 4 else row for index, row in enumerate(WINDOW.images)]
    found = handed_over(images=images)
    rear = found.keyframe[found.camera == LEFT_REAR]
    assert len(rear) > 3 and (rear == 4).all()
