"""How much faster than real time the car's physics runs, on every kind of ground."""

from __future__ import annotations

import time

import numpy as np
import pytest

from sim.seeds import rng_for
from sim.streets.relief import Relief, draw_hills, draw_roughness
from sim.vehicle.drive import DriveConfig
from sim.vehicle.motion import Motion
from tests.drives import CAR, STRAIGHT


@pytest.mark.parametrize("speed_mps", [8.0, 40.0])
@pytest.mark.parametrize("ground", ["flat", "hills", "rough"])
def test_physics_is_much_faster_than_the_drive(ground: str, speed_mps: float) -> None:
    rng = rng_for(1, "test")
    hills = draw_hills(8.0, STRAIGHT.points_m[:800], rng)
    relief = Relief(hills, draw_roughness(3.0 if ground == "rough" else 0.0, rng))
    road = None if ground == "flat" else relief
    motion = Motion(DriveConfig(speed_mps=speed_mps, distance_m=600.0), STRAIGHT, road, CAR)
    started_s = time.process_time()
    for time_s in np.arange(0.0, 10.0, 0.1):
        motion.state_at(float(time_s))
    ratio = 10.0 / (time.process_time() - started_s)
    print(f"{ground}, {speed_mps:g} m/s: {ratio:.0f} times real time")
    assert ratio > 15  # 20 and more on an idle core
