"""Truth channels of a lively street through fisheyes, against rays that MuJoCo casts without any graphics."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
import numpy.typing as npt
import pytest

from estimator.se3 import SE3, Array
from scenarios.load import load_scenario
from sim.channels.flow import flow_px
from sim.channels.labels import label_geoms
from sim.channels.survey import Sight, Survey, Surveyor
from sim.channels.visibility import visibility
from sim.rendering.geom_picture import SKY, GeomRenderer
from sim.scene import build_scene
from sim.stage import Stage
from sim.vehicle.car import CHASSIS

NOW_S, LATER_S = 1.0, 1.1
SETTINGS = (
    "rig=fisheye",  # 190 deg, five faces each, and two pinholes
    "street.kind=straight",
    "street.length_m=40",
    "drive.distance_m=10",
    "street.traffic={cars: 3, cyclists: 3, pedestrians: 3}",
)
DRAWN_GROUPS = np.array([1, 1, 1, 0, 0, 0], np.uint8)
PIXELS = 400


@dataclass(frozen=True, eq=False)
class World:
    """Surveys of two instants, and what casts rays at them: a copy of the state of each."""

    model: mujoco.MjModel
    datas: tuple[mujoco.MjData, mujoco.MjData]
    now: Survey
    later: Survey

    def cast(self, instant: int, origin_m: Array, rays_world: Array) -> tuple[npt.NDArray[np.int32], Array]:
        """Return (N,) geoms and (N,) distances; ``SKY`` and infinite where nothing is hit."""
        geoms, ranges_m = np.full(len(rays_world), SKY, np.int32), np.full(len(rays_world), np.inf)
        for index, ray in enumerate(rays_world):
            data, found = self.datas[instant], geoms[index : index + 1]
            range_m = mujoco.mj_ray(self.model, data, origin_m, ray, DRAWN_GROUPS, 1, -1, found)
            ranges_m[index] = range_m if found[0] >= 0 else np.inf
        return geoms, ranges_m

    def is_free(self, instant: int, origin_m: Array, points_world: Array) -> npt.NDArray[np.bool_]:
        """Tell which points nothing hides from an origin."""
        ways_m = points_world - origin_m
        distances_m = np.linalg.norm(ways_m, axis=1)
        _, first_m = self.cast(instant, origin_m, ways_m / distances_m[:, None])
        return np.asarray(first_m > 0.98 * distances_m - 0.05)


@pytest.fixture(scope="module")
def world() -> World:
    scenario = load_scenario("urban_bend", SETTINGS)
    scene = build_scene(scenario.world, scenario.rig, seed=0)
    stage, surveyor = Stage(scene, scenario.world.drive), Surveyor(scene.true_cameras, scene.lenses)
    surveys, datas = [], []
    with GeomRenderer(scene.model) as renderer:
        for time_s in (NOW_S, LATER_S):
            data = stage.at(time_s)
            surveys.append(surveyor.survey(renderer, data, time_s))
            datas.append(mujoco.MjData(scene.model))
            mujoco.mj_copyData(datas[-1], scene.model, data)
    return World(scene.model, (datas[0], datas[1]), *surveys)


def places(sight: Sight, chosen: npt.NDArray[np.int64]) -> tuple[Array, Array]:
    """Return (N, 2) pixels and their (N, 3) unit rays in the world, straight from the camera model."""
    width = sight.camera.size_px[0]
    pixels = np.column_stack([chosen % width, chosen // width]).astype(float)
    return pixels, sight.camera.unproject(pixels) @ sight.world_from_cam.rotation.T


def test_depth_and_segmentation_are_what_rays_meet(world: World) -> None:
    rng = np.random.default_rng(0)
    for name, sight in world.now.sights.items():
        chosen = rng.choice(len(sight.geom), PIXELS, replace=False)
        geoms, ranges_m = world.cast(0, sight.world_from_cam.translation, places(sight, chosen)[1])
        alike = geoms == sight.geom[chosen]
        met = alike & (geoms != SKY)
        apart = np.abs(ranges_m[met] / sight.range_m[chosen[met]] - 1)
        print(f"{name}: {alike.mean():.3f} alike, range off by {np.quantile(apart, [0.5, 0.98])}")
        assert alike.mean() > 0.96, "outlines and thin leaves fall either way"
        assert np.median(apart) < 1e-4 and np.quantile(apart, 0.98) < 0.02


def test_visibility_is_the_share_that_rays_from_the_other_camera_reach(world: World) -> None:
    shares, model = visibility(world.now, label_geoms(world.model)), world.model
    compared = []
    for name, sight in world.now.sights.items():
        width, height = sight.camera.size_px
        rows, columns = np.mgrid[2:height:8, 2:width:8]  # every 16th alone is off by 0.01 by chance
        chosen = (rows * width + columns).ravel()
        origin_m, rays_world = sight.world_from_cam.translation, places(sight, chosen)[1]
        geoms, ranges_m = world.cast(0, origin_m, rays_world)
        mine = model.body_rootid[model.geom_bodyid[geoms]] == model.body(CHASSIS).id
        placed = (geoms != SKY) & ~mine
        points_world = origin_m + rays_world[placed] * ranges_m[placed, None]
        for other, seer in world.now.sights.items():
            if other == name:
                continue
            pixels = seer.camera.project(seer.world_from_cam.inverse().apply(points_world))
            inside = points_world[seer.camera.contains(pixels)]
            seen = world.is_free(0, seer.world_from_cam.translation, inside).sum() / len(chosen)
            compared.append((seen, shares[name][other]))
    by_rays, stated = np.array(compared).T
    print(f"worst {np.abs(by_rays - stated).max():.3f} of {len(stated)} pairs, up to {stated.max():.2f}")
    assert np.abs(by_rays - stated).max() < 0.03
    assert stated.max() > 0.5 and stated.min() == 0


def test_flow_leads_where_the_bodies_carry_what_rays_meet(world: World) -> None:
    rng, moving_count = np.random.default_rng(1), 0
    for name, sight in world.now.sights.items():
        moving = np.flatnonzero(is_actor(world, sight.geom))
        chosen = np.concatenate([rng.choice(len(sight.geom), PIXELS, replace=False), rng.choice(moving, 100)])
        pixels, rays_world = places(sight, chosen)
        origin_m, later = sight.world_from_cam.translation, world.later.sights[name]
        geoms, ranges_m = world.cast(0, origin_m, rays_world)
        met = geoms != SKY
        points_world = origin_m + rays_world * np.where(met, ranges_m, 1e6)[:, None]
        carried = np.where(met[:, None], carried_on(world, geoms, points_world), points_world)
        expected_px, seen = _seen_later(world, later.world_from_cam, later, carried)
        rows, columns = pixels.astype(int).T[::-1]
        flow = flow_px(world.now, world.later, name)[rows, columns]
        alike, known = geoms == sight.geom[chosen], np.isfinite(flow[:, 0])
        errors_px = np.linalg.norm(flow - (expected_px - pixels), axis=1)
        good = alike & known & seen
        actors = good & is_actor(world, geoms)
        moving_count += int(actors.sum())
        print(
            f"{name}: {(known == seen)[alike].mean():.3f} agree, {np.quantile(errors_px[good], 0.95):.3f} px"
        )
        assert (known == seen)[alike].mean() > 0.95
        assert np.median(errors_px[good]) < 0.01 and np.quantile(errors_px[good], 0.95) < 0.2
        assert np.quantile(errors_px[actors], 0.9) < 0.5
        as_if_still = later.camera.project(later.world_from_cam.inverse().apply(points_world[actors]))
        off_px = np.linalg.norm(as_if_still - pixels[actors] - flow[actors], axis=1)
        assert np.quantile(off_px, 0.9) > 2, "what moves would be led wrong if it stood still"
    assert moving_count > 300


def is_actor(world: World, geoms: npt.NDArray[np.int32]) -> npt.NDArray[np.bool_]:
    """Tell which geoms belong to traffic."""
    return np.asarray((geoms != SKY) & (world.model.body_mocapid[world.model.geom_bodyid[geoms]] >= 0))


def carried_on(world: World, geoms: npt.NDArray[np.int32], points_world: Array) -> Array:
    """Return where the bodies take points, by the poses of the bodies alone."""
    before, after = world.datas
    body = world.model.geom_bodyid[geoms]
    turned, turns = (data.xmat.reshape(-1, 3, 3)[body] for data in (before, after))
    points_body = np.einsum("nji,nj->ni", turned, points_world - before.xpos[body])
    return np.asarray(np.einsum("nij,nj->ni", turns, points_body) + after.xpos[body])


def _seen_later(
    world: World, world_from_cam: SE3, sight: Sight, points_world: Array
) -> tuple[Array, npt.NDArray[np.bool_]]:
    pixels = sight.camera.project(world_from_cam.inverse().apply(points_world))
    free = world.is_free(1, world_from_cam.translation, points_world)
    return pixels, np.asarray(sight.camera.contains(pixels) & free)
