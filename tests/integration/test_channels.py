"""Truth channels against geometry that is known in closed form, and against the pictures themselves."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import mujoco
import numpy as np
import pytest
from rosbags.rosbag2 import Reader

from estimator.camera import Camera
from estimator.rig_file import read_rig
from estimator.se3 import SE3, Array
from sim.channels.flow import flow_px
from sim.channels.labels import CLASSES, label_geoms
from sim.channels.survey import Surveyor
from sim.channels.visibility import visibility
from sim.messages import TYPES
from sim.rendering.choice import open_renderer
from sim.rendering.geom_picture import SKY, GeomRenderer
from sim.rendering.quality import write_visual_settings
from sim.scene import assemble_scene
from sim.sensing.lens import make_lens
from sim.vehicle.cameras import write_cameras
from sim.vehicle.route import route_along
from tests.box_world import looking
from tests.integration.conftest import Command

RIGS = Path(__file__).parents[2] / "scenarios" / "rigs"
GAP = read_rig(RIGS / "gap.yaml")
CAMERAS = {
    "pinhole": GAP["front"].camera,
    "brown_conrady": GAP["left_front"].camera,
    "kannala": GAP["rear"].camera,
}
BALL_M, RADIUS_M = np.array([4.0, 0.5, 1.2]), 0.8
DOWN = SE3.exp(np.array([-0.15, 0.1, 0.2, 0, 0, 0]))  # a little down, to the side, and rolled
NUDGE = SE3.exp(np.array([0.01, 0.02, -0.01, 0.05, 0.0, 0.2]))


def painted_world(cameras: dict[str, Camera], poses: dict[str, SE3]) -> mujoco.MjModel:
    """Compile a ground, walls all around, a ball, and a box that can move, all with speckled paint."""
    spec, rng = mujoco.MjSpec(), np.random.default_rng(0)
    spec.visual.headlight.ambient, spec.visual.headlight.diffuse = [1, 1, 1], [0, 0, 0]
    spec.visual.headlight.specular = [0, 0, 0]
    paint = spec.add_texture(
        name="speckles", type=mujoco.mjtTexture.mjTEXTURE_2D, width=512, height=512, nchannel=3
    )
    speckles = cv2.GaussianBlur(rng.uniform(0, 255, (512, 512)), (0, 0), 3)
    speckles = cv2.normalize(speckles, None, 0, 255, cv2.NORM_MINMAX)
    paint.data = np.repeat(speckles.astype(np.uint8)[..., None], 3, axis=2).tobytes()
    material = spec.add_material(name="speckled", texuniform=True, texrepeat=[0.5, 0.5])
    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = "speckles"
    plain = {"material": "speckled", "contype": 0, "conaffinity": 0}
    world, kinds = spec.worldbody, mujoco.mjtGeom
    world.add_geom(name="ground", type=kinds.mjGEOM_BOX, size=[40, 40, 1], pos=[0, 0, -1], **plain)
    for turn in range(4):
        side = np.array([np.cos(turn * np.pi / 2), np.sin(turn * np.pi / 2)])
        world.add_geom(
            type=kinds.mjGEOM_BOX,
            size=[*np.where(side.round() == 0, 20, 0.5), 2],
            pos=[*12 * side, 2],
            **plain,
        )
    world.add_geom(name="ball", type=kinds.mjGEOM_SPHERE, size=[RADIUS_M, 0, 0], pos=BALL_M, **plain)
    mover = world.add_body(name="car_1", pos=[5, -1.5, 0.7], mocap=True)
    mover.add_geom(name="box", type=kinds.mjGEOM_BOX, size=[0.6, 0.6, 0.6], **plain)
    spec.visual.quality.numslices, spec.visual.quality.numstacks = 256, 128
    lenses = {name: make_lens(camera) for name, camera in cameras.items()}
    write_cameras(world, {name: lens.source for name, lens in lenses.items()}, poses)
    largest = np.max([lens.largest_px for lens in lenses.values()], axis=0)
    write_visual_settings(spec, (int(largest[0]), int(largest[1])))
    return spec.compile()


@pytest.mark.parametrize("camera", CAMERAS.values(), ids=CAMERAS.keys())
def test_depth_is_the_distance_along_each_pixels_ray(camera: Camera) -> None:
    pose = looking(0) @ DOWN
    model = painted_world({"eye": camera}, {"eye": pose})
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with GeomRenderer(model) as renderer:
        surveyor = Surveyor({"eye": camera}, {"eye": make_lens(camera)})
        sight = surveyor.survey(renderer, data, 0.0).sights["eye"]
    rays_world = sight.lines.rays_cam @ pose.rotation.T
    for name, expected_m in (("ground", ground_m(pose, rays_world)), ("ball", ball_m(pose, rays_world))):
        seen = sight.geom == model.geom(name).id
        errors_m = np.abs(sight.range_m - expected_m)[seen]
        print(name, seen.mean(), np.nanmedian(errors_m), np.nanquantile(errors_m, 0.99))
        assert seen.mean() > 0.02
        assert np.nanmedian(errors_m) < 0.002
        assert np.nanquantile(errors_m, 0.98) < 0.02  # a ball's rim is steep, and drawn as a polygon
    assert np.isinf(sight.range_m[sight.geom == SKY]).all()


def ground_m(pose: SE3, rays_world: Array) -> Array:
    """Return the distance to z = 0."""
    return np.asarray(-pose.translation[2] / rays_world[:, 2])


def ball_m(pose: SE3, rays_world: Array) -> Array:
    """Return the distance to the ball, NaN for rays that miss it."""
    to_ball = BALL_M - pose.translation
    along = rays_world @ to_ball
    with np.errstate(invalid="ignore"):
        return np.asarray(along - np.sqrt(along**2 - to_ball @ to_ball + RADIUS_M**2))


def test_flow_leads_to_the_same_paint_in_the_next_image() -> None:
    camera, pose = GAP["front"].camera, looking(0) @ DOWN
    model = painted_world({"eye": camera}, {"eye": pose})
    surveyor = Surveyor({"eye": camera}, {"eye": make_lens(camera)})
    data = mujoco.MjData(model)
    pictures, surveys = [], []
    with open_renderer("classic", model) as eyes, GeomRenderer(model) as geoms:
        for index in range(2):
            model.cam_pos[0] = (pose @ NUDGE).translation if index else pose.translation
            data.mocap_pos[0] = [5, -1.5 + 0.3 * index, 0.7]
            mujoco.mj_forward(model, data)
            survey = surveyor.survey(geoms, data, float(index))
            views = make_lens(camera).views("eye", survey.sights["eye"].world_from_cam)
            pictures.append(eyes.render(data, views)["eye"].rgb[..., 1].astype(np.float32))
            surveys.append(survey)
    flow = flow_px(*surveys, "eye")
    rows, columns = np.mgrid[: flow.shape[0], : flow.shape[1]].astype(np.float32)
    led = cv2.remap(pictures[1], columns + flow[..., 0], rows + flow[..., 1], cv2.INTER_CUBIC)
    known = np.isfinite(flow[..., 0])
    errors, still = np.abs(led - pictures[0])[known], np.abs(pictures[1] - pictures[0])[known]
    print(
        f"known {known.mean():.3f}; with flow {np.median(errors):.2f}, without {np.median(still):.2f} levels"
    )
    assert 0.8 < known.mean() < 1.0
    assert np.median(errors) < 0.15 * np.median(still)
    on_box = (surveys[0].sights["eye"].geom == model.geom("box").id).reshape(known.shape)
    on_ground = (surveys[0].sights["eye"].geom == model.geom("ground").id).reshape(known.shape)
    beside = flow[on_box & known][:, 0].mean() - flow[on_ground & known][:, 0].mean()
    assert beside < -20, "the box moves to the left, by 0.3 m at 5 m"


def test_flow_is_unknown_where_something_has_moved_in_front() -> None:
    camera, pose = GAP["front"].camera, looking(0) @ DOWN
    model = painted_world({"eye": camera}, {"eye": pose})
    surveyor = Surveyor({"eye": camera}, {"eye": make_lens(camera)})
    data, surveys = mujoco.MjData(model), []
    with GeomRenderer(model) as geoms:
        for side_m in (-1.5, -0.7):
            data.mocap_pos[0] = [3, side_m, 0.7]
            mujoco.mj_forward(model, data)
            surveys.append(surveyor.survey(geoms, data, side_m))
    flow = flow_px(*surveys, "eye")
    box = model.geom("box").id
    before, after = (survey.sights["eye"].geom.reshape(flow.shape[:2]) == box for survey in surveys)
    hidden = cv2.erode((after & ~before).astype(np.uint8), np.ones((5, 5))) > 0
    assert hidden.sum() > 500
    assert np.isnan(flow[hidden]).all()
    untouched = ~cv2.dilate((after | before).astype(np.uint8), np.ones((5, 5))).astype(bool)
    assert np.abs(flow[untouched]).max() < 1e-2


@pytest.mark.parametrize(("rig", "shares"), [("gap", False), ("overlap", True)])
def test_front_and_rear_group_share_a_view_only_where_the_rig_says_so(rig: str, shares: bool) -> None:
    true_rig = read_rig(RIGS / f"{rig}.yaml")
    seen = _visibility(true_rig)
    front, rear = ("front", "front_right", "left_front", "right_front"), ("rear", "left_rear", "right_rear")
    across = [seen[a][b] for a in (*front, *rear) for b in (*front, *rear) if (a in front) != (b in front)]
    assert (max(across) > 0.01) == shares and (shares or max(across) == 0)
    assert seen["front"]["front_right"] > 0.3 and seen["left_front"]["front"] > 0.03
    assert seen["rear"]["left_rear"] > 0.05


def _visibility(rig: object) -> dict[str, dict[str, float]]:
    def write_walls(spec: mujoco.MjSpec) -> None:
        for turn in np.linspace(0, 2 * np.pi, 24, endpoint=False):
            place = 9 * np.array([np.cos(turn), np.sin(turn)])
            spec.worldbody.add_geom(
                type=mujoco.mjtGeom.mjGEOM_BOX, size=[1.3, 1.3, 3], pos=[*place, 3], contype=0, conaffinity=0
            )

    scene = assemble_scene(
        write_walls, route_along(np.column_stack([np.arange(0, 30, 0.5), np.zeros(60)])), rig
    )
    data = mujoco.MjData(scene.model)
    mujoco.mj_forward(scene.model, data)
    with GeomRenderer(scene.model) as renderer:
        survey = Surveyor(scene.true_cameras, scene.lenses).survey(renderer, data, 0.0)
    return visibility(survey, label_geoms(scene.model))


def test_a_recording_carries_what_was_asked_for_and_the_same_images(
    house: Path, command: Command, tmp_path: Path
) -> None:
    settings = "base: ./tiny.yaml\nabout: Truth.\ntruth: [depth, segmentation, optical_flow, visibility]\n"
    (house / "tiny_truth.yaml").write_text(settings)
    for name, bag in (("tiny", "plain"), ("tiny_truth", "truth")):
        assert command("record", house / f"{name}.yaml", "--out", bag, "--quiet") == 0
    plain, truth = _messages(tmp_path / "plain"), _messages(tmp_path / "truth")
    assert all(plain[topic] == truth[topic] for topic in plain), "asking for truth changes no image"
    assert not any(topic.startswith("/truth/front/") for topic in plain)
    for kind, encoding, count in (
        ("depth", "32FC1", 3),
        ("class", "mono8", 3),
        ("instance", "16UC1", 3),
        ("optical_flow", "32FC2", 2),
    ):
        messages = truth[f"/truth/front/{kind}"]
        assert len(messages) == count
        image = TYPES.deserialize_cdr(messages[0], "sensor_msgs/msg/Image")
        assert (image.encoding, image.width, image.height) == (encoding, 64, 40)
        assert len(image.data) == image.step * image.height
    labels = json.loads(TYPES.deserialize_cdr(truth["/truth/labels"][0], "std_msgs/msg/String").data)
    assert labels["classes"] == list(CLASSES) and "chassis" in labels["instances"]
    shares = json.loads(TYPES.deserialize_cdr(truth["/truth/visibility"][0], "std_msgs/msg/String").data)
    assert shares["front"]["rear"] == 0 and set(shares) == {"front", "left_front", "rear"}


def _messages(bag: Path) -> dict[str, list[bytes]]:
    messages: dict[str, list[bytes]] = {}
    with Reader(bag) as reader:
        for connection, _, raw in reader.messages():
            messages.setdefault(connection.topic, []).append(bytes(raw))
    return messages
