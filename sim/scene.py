"""One compiled world: street, light, ground, car and its cameras at their true poses."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import mujoco

from estimator.camera import Camera
from estimator.rig import Rig
from sim.faults.wrong_intrinsics import with_true_lenses
from sim.light.atmosphere import Atmosphere
from sim.light.outdoors import glows_of, write_outdoors
from sim.light.surroundings import surroundings_of
from sim.rendering.names import Quality
from sim.rendering.quality import write_visual_settings
from sim.seeds import rng_for
from sim.sensing.lens import Lens, make_lens
from sim.streets.street import build_street
from sim.traffic.planned import traffic_of
from sim.traffic.traffic import NOBODY, Traffic
from sim.vehicle.cameras import MovingCameras, write_cameras
from sim.vehicle.car import CarConfig, write_car
from sim.vehicle.car_physics import physics_spec
from sim.vehicle.ground_contact import Road
from sim.vehicle.miscalibration import STEADY, Mounts, miscalibrate, moving_mounts
from sim.vehicle.route import Route, route_along
from sim.world import WorldConfig


@dataclass(frozen=True, eq=False)
class Scene:
    """What simulating needs besides the settings.

    Attributes:
        model: Compiled; one camera element a camera of the rig.
        lenses: By camera.
        true_cameras: What each lens makes images of.
        route: What the car drives.
        cameras: Those whose mounting changes.
        car: The car's sizes.
        road: What its wheels feel; None for the plane z = 0.
        atmosphere: Light and weather between renderer and lenses; None for clear air by day.
        traffic: Everything else that moves.
    """

    model: mujoco.MjModel
    lenses: Mapping[str, Lens]
    true_cameras: Mapping[str, Camera]
    cameras: MovingCameras
    route: Route
    car: CarConfig
    road: Road | None = None
    atmosphere: Atmosphere | None = None
    traffic: Traffic = NOBODY


def build_scene(config: WorldConfig, nominal: Rig, seed: int) -> Scene:
    """Build the world of a seed; only its drive remains to be done."""
    mounts = moving_mounts(nominal, config.miscalibration, seed)
    street = build_street(config.street, rng_for(seed, "street"))
    ego_from_cams = miscalibrate(nominal, config.miscalibration, seed)
    true_rig = with_true_lenses(nominal, config.faults).with_extrinsics(ego_from_cams)
    relief, closed = street.network.relief, street.network.route.closed
    route = route_along(street.centerline_m, closed)
    road = None if relief.is_flat else relief
    cameras = {name: mounted.camera for name, mounted in true_rig.cameras.items()}
    surroundings = surroundings_of(street.network, street.lamps)
    atmosphere = Atmosphere(config.weather, surroundings, cameras, seed)
    traffic = traffic_of(config.street.traffic, street.network, street.scenery, config.drive, route, seed)

    def write_scenery(spec: mujoco.MjSpec) -> None:
        street.write_into(spec)
        traffic.write_into(spec)

    skins = [street.scenery.skins, *(model.skins for troupe in traffic.troupes for model in troupe.models)]
    glows = glows_of(skins) if atmosphere.in_channels else None

    def write_light(spec: mujoco.MjSpec) -> None:
        write_outdoors(spec, config.weather, seed, glows)

    scene = assemble_scene(write_scenery, route, true_rig, road, mounts, config.quality, write_light)
    return replace(scene, atmosphere=atmosphere, traffic=traffic)


def assemble_scene(
    write_scenery: Callable[[mujoco.MjSpec], None],
    route: Route,
    true_rig: Rig,
    road: Road | None = None,
    mounts: Mounts = STEADY,
    quality: Quality = "standard",
    write_light: Callable[[mujoco.MjSpec], None] = lambda spec: None,
) -> Scene:
    """Compile the car with its true rig into whatever ``write_scenery`` adds; ``write_light`` comes last."""
    lenses = {name: make_lens(mounted.camera) for name, mounted in true_rig.cameras.items()}
    sources = {name: lens.source for name, lens in lenses.items()}
    car = CarConfig()
    spec = physics_spec()
    write_scenery(spec)
    chassis = write_car(spec, car)
    ego_from_cams = {name: mounted.ego_from_cam for name, mounted in true_rig.cameras.items()}
    write_cameras(chassis, sources, ego_from_cams)
    write_light(spec)
    write_visual_settings(spec, _largest_px(lenses), quality)
    model = spec.compile()
    true_cameras = {name: mounted.camera for name, mounted in true_rig.cameras.items()}
    return Scene(model, lenses, true_cameras, MovingCameras(model, mounts), route, car, road)


def _largest_px(lenses: Mapping[str, Lens]) -> tuple[int, int]:
    widths, heights = zip(*(lens.largest_px for lens in lenses.values()), strict=True)
    return max(widths), max(heights)
