"""Anchors: the middle sighting, and the plane that explains the others."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.anchors import choose_anchors
from tests.canyon_window import look
from tests.mounts import arc, left_side_rig

WINDOW = look(left_side_rig(), arc(0.8, 3), ("front", "left_front"), 100)
NOT_ROAD = np.zeros(len(WINDOW.normals_world), bool)
ANCHORS = choose_anchors(WINDOW.scene, WINDOW.observations, WINDOW.images, NOT_ROAD)
SEEN_TWICE = np.bincount(WINDOW.observations.landmark, minlength=len(WINDOW.normals_world)) >= 3


def facing(landmark: np.ndarray) -> np.ndarray:
    """Return the cosine between the chosen and the true normal, whatever its sign."""
    return np.abs(np.einsum("ni,ni->n", ANCHORS.normals_world[landmark], WINDOW.normals_world[landmark]))


def test_the_anchor_is_the_middle_sighting() -> None:
    chosen = np.flatnonzero(ANCHORS.valid & SEEN_TWICE)
    assert len(chosen) > 50
    assert (ANCHORS.keyframe[chosen] == 1).all()
    true_px = WINDOW.true_px(chosen, ANCHORS.camera[chosen], ANCHORS.keyframe[chosen])
    np.testing.assert_allclose(ANCHORS.pixels[chosen], true_px)


def test_a_patch_on_the_road_gets_the_road_s_normal() -> None:
    road = np.flatnonzero(ANCHORS.valid & SEEN_TWICE & (WINDOW.scene.points_world[:, 2] < 1e-6))
    assert len(road) > 15
    assert np.mean(ANCHORS.normals_world[road, 2] > 0.99) > 0.8


def test_a_patch_on_a_facade_gets_the_facade_s_normal_or_one_near_it() -> None:
    on_wall = np.abs(WINDOW.scene.points_world[:, 1]) > 5.99
    wall = np.flatnonzero(ANCHORS.valid & SEEN_TWICE & on_wall & (ANCHORS.camera == 1))
    assert len(wall) > 15
    assert np.mean(facing(wall) > 0.999) > 0.35
    assert np.mean(facing(wall) > 0.85) > 0.75


def test_normals_are_of_unit_length_and_face_the_camera() -> None:
    chosen = np.flatnonzero(ANCHORS.valid)
    _, center = WINDOW.scene.pose_arrays(ANCHORS.camera[chosen], ANCHORS.keyframe[chosen])
    normals = ANCHORS.normals_world[chosen]
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1)
    assert (np.einsum("ni,ni->n", normals, center - WINDOW.scene.points_world[chosen]) > 0).all()


def test_landmarks_without_a_point_or_of_another_camera_s_finding_get_none() -> None:
    points = WINDOW.scene.points_world.copy()
    points[::2] = np.nan
    unknown = choose_anchors(
        replace(WINDOW.scene, points_world=points), WINDOW.observations, WINDOW.images, NOT_ROAD
    )
    assert not unknown.valid[::2].any() and unknown.valid[1::2].any()
    found = replace(WINDOW.observations, handed_over=np.ones(len(WINDOW.observations), bool))
    assert not choose_anchors(WINDOW.scene, found, WINDOW.images, NOT_ROAD).valid.any()


def test_what_is_known_to_be_road_gets_the_road_s_normal_whatever_it_looks_like() -> None:
    seen = WINDOW.scene.points_world[:, 2] < 1e-6
    known = choose_anchors(WINDOW.scene, WINDOW.observations, WINDOW.images, seen)
    road = np.flatnonzero(known.valid & seen & np.isfinite(known.normals_world).all(1))
    assert len(road) > 15 and np.mean(known.normals_world[road, 2] > 0.99) > 0.95  # the rest is seen edge-on
    facade = np.flatnonzero(ANCHORS.valid & ~seen)
    np.testing.assert_array_equal(known.normals_world[facade], ANCHORS.normals_world[facade])
