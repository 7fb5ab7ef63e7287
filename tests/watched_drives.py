"""Drives of a few windows, watched for wrong lenses and late clocks, and what is stated after them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from estimator.belief import Belief
from estimator.clocks import Clocks
from estimator.corrections import rig_at
from estimator.estimate import CameraEstimate
from estimator.graph import adjust
from estimator.ledger import Ledger, LedgerConfig
from estimator.lens_config import LensConfig, Refine
from estimator.lens_watch import LensWatch
from estimator.loss import Loss
from estimator.off_nominal import OffNominal
from estimator.se3 import SE3, Array
from estimator.window_config import WindowConfig
from estimator.window_result import WindowResult
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import BROWN, arc, left_side_rig

NOMINAL = left_side_rig(left_front=BROWN)
STAMPS_NS = tuple(200_000_000 * k for k in range(9))
STRAIGHT = arc(1.0, 9, 0.0)
# At 5 m/s round 25 m the rear axle slips to the outside: the car heads a little into the bend.
BEND = tuple(pose.retract(np.array([0.0, 0.0, 0.006, 0.0, 0.0, 0.0])) for pose in arc(1.0, 9, 1 / 25))
IN_TIME = (0.0, 0.0, 0.0)
LATE = (0.0, 0.0, 0.02)
ANY_LENS = LensConfig()


def watched(
    *paths: tuple[SE3, ...],
    unknowns: Array | None = None,
    ahead_s: tuple[float, ...] = IN_TIME,
    refine: Refine = "none",
    config: LensConfig = ANY_LENS,
) -> LensWatch:
    """Return what is known once windows along the paths were adjusted as if lenses and clocks were right."""
    watch = LensWatch(NOMINAL, config, WindowConfig(), refine)
    for seed, path in enumerate(paths):
        true_rig = NOMINAL if unknowns is None else rig_at(NOMINAL, unknowns)
        truth = replace(known_scene(true_rig, path, 15, seed), clocks=Clocks(STAMPS_NS, ahead_s))
        seen = sightings(truth, 0.1, seed)
        start = replace(truth, rig=NOMINAL, clocks=None, stamps_ns=STAMPS_NS)
        before = Belief.nominal(NOMINAL)
        scene = adjust(start, seen, on_road(truth), before, Loss(0.1), WindowConfig().graph).scene
        watch.learn(scene, seen)
    return watch


def stated(watch: LensWatch) -> Mapping[str, CameraEstimate]:
    """Return what is stated of every camera, were there sightings enough for anything."""
    scene = known_scene(NOMINAL, STRAIGHT)
    plenty = dict.fromkeys(NOMINAL.cameras, 500)
    ledger = Ledger(NOMINAL, LedgerConfig(), OffNominal())
    ledger.add(WindowResult(watch.belief, plenty, plenty, 0.1, (), scene, sightings(scene), 0))
    nobody_missed = dict.fromkeys(NOMINAL.cameras, 0)
    return ledger.cameras(watch.belief, nobody_missed, watch.findings, watch.lenses, watch.doubt)
