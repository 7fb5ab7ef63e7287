"""The plan of a street before anything is built: its path, bend, junction and cross-section, drawn by seed.

Street coordinates: s along the driven lane, d to its left. Traffic keeps right, so the oncoming lane is on
the left. The side street leaves on the outside of the bend, where the houses leave room for it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.streets.path import STEP_M, Path, bend_curvature, bend_length_m, path_from_curvature, straight_path

BEHIND_M = 45.0
BEYOND_M = 60.0
LANE_M = 3.1
PARKING_M = 2.1
BAY_M = 5.6
KERB_M = 0.12
SIDE_DEPTH_M = 46.0
LATER_BEND_EVERY_M = 85.0


@dataclass(frozen=True)
class Section:
    """Where kerbs and facade lines lie across the street: d in metres, left positive."""

    kerb_left_m: float
    kerb_right_m: float
    front_left_m: float
    front_right_m: float
    center_line_m: float
    parking_side: int  # +1 left, -1 right, 0 none

    def kerb_m(self, side: int) -> float:
        """Kerb on the left (+1) or right (-1)."""
        return self.kerb_left_m if side > 0 else self.kerb_right_m

    def front_m(self, side: int) -> float:
        """Facade line on the left (+1) or right (-1)."""
        return self.front_left_m if side > 0 else self.front_right_m


@dataclass(frozen=True, eq=False)
class Junction:
    """A side street that joins at right angles.

    Attributes:
        s_m: Where, along the main street.
        side: +1 left, -1 right.
        half_width_m: Half its carriageway.
        corner_m: Radius of the kerb at its corners.
        path: Its own path, from the lane centre of the main street outwards.
        section: Its cross-section.
    """

    s_m: float
    side: int
    half_width_m: float
    corner_m: float
    path: Path
    section: Section


@dataclass(frozen=True, eq=False)
class Layout:
    """The whole plan."""

    length_m: float
    path: Path
    section: Section
    junction: Junction
    bend_start_m: float
    bend_end_m: float

    @property
    def mouth_m(self) -> tuple[float, float]:
        """Interval of s in which the pavement is open for the side street, corners included."""
        half = self.junction.half_width_m + self.junction.corner_m
        return self.junction.s_m - half, self.junction.s_m + half


def draw_layout(length_m: float, rng: np.random.Generator) -> Layout:
    """Draw the plan of a street with a bend and a junction within the first sixty metres."""
    turn = float(rng.choice([-1.0, 1.0]))
    angle_rad = turn * np.deg2rad(rng.uniform(47, 56))
    radius_m = float(rng.uniform(23.0, 25.0))
    junction_first = bool(rng.random() < 0.5)
    bend_start_m = float(rng.uniform(24, 26) if junction_first else rng.uniform(10, 12))
    bend_end_m = bend_start_m + bend_length_m(angle_rad, radius_m)
    junction_m = float(rng.uniform(12.5, 13.5)) if junction_first else bend_end_m + 7.5
    path = _main_path(length_m, bend_start_m, angle_rad, radius_m)
    section = _main_section(rng)
    return Layout(
        length_m, path, section, _junction(path, junction_m, -int(turn), rng), bend_start_m, bend_end_m
    )


def _main_path(length_m: float, bend_start_m: float, angle_rad: float, radius_m: float) -> Path:
    s_m = np.arange(-BEHIND_M, length_m + BEYOND_M + STEP_M / 2, STEP_M)
    curvature = bend_curvature(s_m, bend_start_m, angle_rad, radius_m)
    # Later bends alternate, so that a long street never crosses itself.
    later, sign = bend_start_m + LATER_BEND_EVERY_M, -1.0
    while later < length_m + BEYOND_M:
        curvature += bend_curvature(s_m, later, sign * angle_rad, radius_m + 4.0)
        later, sign = later + LATER_BEND_EVERY_M, -sign
    return path_from_curvature(-BEHIND_M, curvature)


def _main_section(rng: np.random.Generator) -> Section:
    parking = int(rng.choice([-1, 1]))
    kerb_right = -LANE_M / 2 - (PARKING_M if parking < 0 else 0.3)
    kerb_left = 1.5 * LANE_M + (PARKING_M if parking > 0 else 0.1)
    # Without a parking strip the pavement is wider, so that facades stand five metres or more from the lane.
    pavement_right = rng.uniform(2.4, 3.0) if parking < 0 else rng.uniform(4.0, 4.8)
    pavement_left = rng.uniform(2.4, 3.0)
    return Section(
        kerb_left, kerb_right, kerb_left + pavement_left, kerb_right - pavement_right, LANE_M / 2, parking
    )


def _junction(path: Path, s_m: float, side: int, rng: np.random.Generator) -> Junction:
    half, pavement = float(rng.uniform(2.8, 3.2)), 2.2
    heading = float(path.heading_rad(s_m)) + side * np.pi / 2
    own = straight_path(path.point_m(s_m), heading, SIDE_DEPTH_M)
    section = Section(half, -half, half + pavement, -half - pavement, 0.0, 0)
    return Junction(s_m, side, half, 5.2, own, section)


def lane_centerline_m(layout: Layout) -> Array:
    """(N, 2) centre of the driven lane from the origin on, somewhat longer than the street."""
    s_m = np.arange(0.0, layout.length_m + 20.0, 0.25)
    return layout.path.point_m(s_m)
