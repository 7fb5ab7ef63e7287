"""Every renderer draws the same world from the same place: exactly, repeatably, each by its own code."""

from __future__ import annotations

import gc
import hashlib
import subprocess
import sys

import mujoco
import numpy as np
import pytest

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.rendering.choice import RENDERER_NAMES, open_renderer
from sim.rendering.names import RendererName
from sim.rendering.quality import write_visual_settings
from sim.rendering.view import FAR_M, Picture, View
from sim.scene import physics_spec
from tests.ball_world import balls_in_view, expected_centroid_px, measured_centroid_px, write_balls
from tests.box_world import VIEWS, box_world

TOLERANCE_PX = 0.1
SYSTEMATIC_TOLERANCE_PX = 0.02
OFF_CENTRE = Camera("pinhole", (640, 400), (400.0, 380.0), (290.3, 221.7))
TILTED = SE3.exp(np.array([0.1, 0.2, -2.0, 5.0, -3.0, 1.0]))


@pytest.mark.parametrize("name", RENDERER_NAMES)
def test_balls_appear_where_the_camera_projects_them(name: RendererName) -> None:
    centers, radii_m = balls_in_view(OFF_CENTRE, TILTED, radius_px=6.0, margin_px=12)
    spec = physics_spec()
    write_balls(spec, centers, radii_m)
    write_visual_settings(spec, OFF_CENTRE.size_px)
    picture = draw(name, spec.compile(), {"eye": View(OFF_CENTRE, TILTED)})["eye"]
    image = picture.rgb[..., 1]  # the balls are white
    errors_px = np.array(
        [
            measured_centroid_px(image, pixel, 11) - pixel
            for pixel in map(
                expected_centroid_px,
                [OFF_CENTRE] * len(centers),
                TILTED.inverse().apply(centers),
                radii_m,
            )
        ]
    )
    worst_px = np.linalg.norm(errors_px, axis=1).max()
    print(f"{name}: {len(errors_px)} balls, worst {worst_px:.3f} px, mean {errors_px.mean(0)}")
    assert worst_px < TOLERANCE_PX
    assert np.abs(errors_px.mean(0)).max() < SYSTEMATIC_TOLERANCE_PX


@pytest.mark.parametrize("name", ["pyrender", "filament"])
def test_depth_agrees_with_the_classic_renderer(name: RendererName) -> None:
    model = box_world("draft")  # one sample a pixel, at its centre
    theirs, ours = (draw(each, model, VIEWS, depth=True) for each in (name, "classic"))
    for view in VIEWS:
        depth_m, reference_m = theirs[view].depth_m, ours[view].depth_m
        assert depth_m is not None and reference_m is not None
        apart_m = np.abs(depth_m - reference_m)
        near = reference_m < 10
        assert np.median(apart_m[near]) < 0.002
        assert np.mean(apart_m > 0.001 * reference_m) < 0.005, "only outlines may differ by more"
        assert near.mean() > 0.1 and (reference_m == FAR_M).mean() > 0.05


@pytest.mark.parametrize("name", ["pyrender", "filament"])
def test_light_is_about_as_bright_as_the_classic_renderers(name: RendererName) -> None:
    model = box_world()
    theirs, ours = draw(name, model, VIEWS), draw("classic", model, VIEWS)
    for view in VIEWS:
        below = ours[view].rgb[100:].mean(), theirs[view].rgb[100:].mean()
        assert 0.75 < below[1] / below[0] < 1.33


@pytest.mark.parametrize("name", RENDERER_NAMES)
def test_what_moves_is_drawn_where_it_is(name: RendererName) -> None:
    model = box_world()
    data = mujoco.MjData(model)
    with open_renderer(name, model) as renderer:
        reddest = []
        for side_m in (0.0, 1.0):
            data.mocap_pos[0] = [6, side_m, 1.5]
            mujoco.mj_forward(model, data)
            rgb = renderer.render(data, VIEWS)["ahead"].rgb.astype(float)
            red = rgb[..., 0] > 2 * rgb[..., 1]
            reddest.append(np.nonzero(red)[1].mean())
    assert reddest[0] - reddest[1] == pytest.approx(150 / 6, abs=3)


@pytest.mark.parametrize("name", RENDERER_NAMES)
def test_pictures_depend_neither_on_the_process_nor_on_what_was_drawn_before(name: RendererName) -> None:
    draw(name, box_world(seed=1), {"left": VIEWS["left"]})  # another world, first
    here = digest(name)
    answer = subprocess.run(
        (
            sys.executable,
            "-c",
            f"import sim, tests.integration.test_renderers as t; print(t.digest('{name}'))",
        ),
        capture_output=True,
        text=True,
        check=True,
    )
    assert answer.stdout.split() == [here]


@pytest.mark.parametrize("name", RENDERER_NAMES)
def test_a_renderer_comes_and_goes_beside_others(name: RendererName) -> None:
    model = box_world()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, 160, 240) as plain, open_renderer("classic", model) as classic:
        before = classic.render(data, VIEWS)["left"].rgb
        plain.update_scene(data)
        plain_before = plain.render()
        draw(name, model, VIEWS, depth=True)
        gc.collect()
        assert np.array_equal(classic.render(data, VIEWS)["left"].rgb, before)
        plain.update_scene(data)
        assert np.array_equal(plain.render(), plain_before)


@pytest.mark.parametrize("name", RENDERER_NAMES)
def test_draft_draws_no_shadows(name: RendererName) -> None:
    draft, standard = (
        draw(name, box_world(quality), VIEWS)["ahead"].rgb for quality in ("draft", "standard")
    )
    darker = draft.astype(float).mean(-1) - standard.astype(float).mean(-1)
    assert (darker > 25).mean() > 0.01


@pytest.mark.parametrize("name", RENDERER_NAMES)
def test_fine_draws_the_same_world_with_as_many_samples_as_the_driver_has(name: RendererName) -> None:
    standard, fine = (draw(name, box_world(quality), VIEWS)["ahead"].rgb for quality in ("standard", "fine"))
    apart = np.abs(fine.astype(float) - standard).mean(-1)
    assert 0 < apart.mean() < 3, "only outlines and the edges of shadows differ"


def draw(
    name: RendererName, model: mujoco.MjModel, views: dict[str, View], depth: bool = False
) -> dict[str, Picture]:
    """Draw one instant with a renderer of its own."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with open_renderer(name, model) as renderer:
        return renderer.render(data, views, depth)


def digest(name: RendererName) -> str:
    """Return a digest of the second of two pictures of every view."""
    model = box_world()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with open_renderer(name, model) as renderer:
        renderer.render(data, VIEWS)
        pictures = renderer.render(data, VIEWS)
    return hashlib.sha256(b"".join(pictures[view].rgb.tobytes() for view in VIEWS)).hexdigest()
