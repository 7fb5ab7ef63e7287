"""The car alone as a MuJoCo model of its own, with all that acts on it; what it drives through is not in it.

So the physics costs the same in every street, and nothing that is only seen can change the drive. The joints
are those of ``write_car``, in the same order: its generalised positions are the car's in any world.
"""

from __future__ import annotations

import mujoco

from sim.vehicle.car import DRIVEN, STEERED, WHEELS, CarConfig, write_joints
from sim.vehicle.tyre import set_tyre

STEP_S = 0.002


def physics_spec() -> mujoco.MjSpec:
    """Return an empty spec with the solver settings that a car on stiff tyres needs."""
    spec = mujoco.MjSpec()
    spec.compiler.degree = False
    spec.option.timestep = STEP_S
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    return spec


def car_model(config: CarConfig, grip: float) -> mujoco.MjModel:
    """Compile the car on a patch of ground a wheel; ``grip`` is the road's coefficient of friction."""
    spec = physics_spec()
    write_joints(spec, config)
    for wheel in WHEELS:
        _write_contact(spec, wheel, config)
    for wheel in STEERED:
        _write_servo(spec, wheel)
    for wheel in DRIVEN:
        motor = spec.add_actuator(
            name=f"{wheel}_motor", target=f"{wheel}_spin", trntype=mujoco.mjtTrn.mjTRN_JOINT
        )
        motor.set_to_motor()
    for front, rear in zip(WHEELS[::2], WHEELS[1::2], strict=True):
        _write_roll_bar(spec, front, rear, config)
    model = spec.compile()
    for wheel in WHEELS:
        set_tyre(model, f"{wheel}_contact", config.tyre, config.tyre_share(wheel), grip)
    return model


def _write_contact(spec: mujoco.MjSpec, wheel: str, config: CarConfig) -> None:
    """Add an invisible ellipsoid (a flat cylinder's edges would grip in curves) and the plane it rolls on."""
    radius_m = config.free_radius_m(wheel)
    spec.body(f"{wheel}_wheel").add_geom(
        name=f"{wheel}_tyre",
        type=mujoco.mjtGeom.mjGEOM_ELLIPSOID,
        size=[radius_m, config.tyre_width_m / 2, radius_m],
        contype=0,
        conaffinity=0,
    )
    patch = spec.worldbody.add_body(name=f"{wheel}_patch", mocap=True)
    patch.add_geom(
        name=f"{wheel}_ground",
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=[0, 0, 1],
        contype=0,
        conaffinity=0,
    )
    spec.add_pair(name=f"{wheel}_contact", geomname1=f"{wheel}_tyre", geomname2=f"{wheel}_ground", condim=3)


def _write_servo(spec: mujoco.MjSpec, wheel: str) -> None:
    servo = spec.add_actuator(
        name=f"{wheel}_servo", target=f"{wheel}_steer", trntype=mujoco.mjtTrn.mjTRN_JOINT
    )
    servo.set_to_position(kp=20_000.0, kv=600.0)


def _write_roll_bar(spec: mujoco.MjSpec, left: str, right: str, config: CarConfig) -> None:
    """Tie the two springs of an axle: the bar is at ease while both are pressed equally."""
    bar = spec.add_tendon(name=f"{left}_bar", stiffness=config.roll_bar_npm, springlength=[0, 0])
    bar.wrap_joint(f"{left}_spring", 1.0)
    bar.wrap_joint(f"{right}_spring", -1.0)
