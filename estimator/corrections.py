"""From evidence, and from a vector of ``Unknowns``, back to a rig and its clocks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.belief import Belief
from estimator.camera import Camera
from estimator.evidence import Evidence, Free, UsualErrors
from estimator.rig import MountedCamera, Rig
from estimator.scene import Scene
from estimator.se3 import Array
from estimator.unknowns import Unknowns

_NOTHING = 1e-6  # of a unit: what a clock or a lens that is held may still be off


def belief_from(evidence: Evidence, usual: UsualErrors, free: Free) -> Belief:
    """Return what all windows' evidence says of poses, lenses and clocks; only those in doubt may change.

    The covariance is stated as if all lenses were in doubt: what patches measure wrongly in one direction
    acts on poses as small errors of lenses do, and with lenses held it would be three times too small.
    """
    nominal = evidence.nominal
    posterior = evidence.posterior(usual, free)
    wary = evidence.posterior(usual, replace(free, lenses=frozenset(nominal.cameras)))
    size = Unknowns(nominal).pose_size
    covariance = wary.covariance[:size, :size] * max(1.0, wary.disagreement)
    ahead_s = dict(zip(nominal.cameras, clocks_at(nominal, posterior.mean), strict=True))
    return Belief(rig_at(nominal, posterior.mean), covariance, ahead_s)


def scene_at(scene: Scene, belief: Belief) -> Scene:
    """Return the scene with poses, lenses and clocks as believed."""
    assert scene.clocks is not None
    ahead_s = tuple(belief.ahead_s[name] for name in scene.rig.cameras)
    return replace(scene, rig=belief.rig, clocks=replace(scene.clocks, ahead_s=ahead_s))


def rig_at(nominal: Rig, values: Array) -> Rig:
    """Return the rig whose poses and lenses differ from the rig file's by (D,) values."""
    unknowns = Unknowns(nominal)
    cameras = {}
    for camera, (name, mounted) in enumerate(nominal.cameras.items()):
        pose = mounted.ego_from_cam
        if name in unknowns.estimated:
            pose = pose.retract(values[unknowns.extrinsics(camera)])
        cameras[name] = MountedCamera(_lens_at(mounted.camera, values[unknowns.lens(camera)]), pose)
    return replace(nominal, cameras=cameras)


def clocks_at(nominal: Rig, values: Array) -> tuple[float, ...]:
    """Return by how many seconds each camera's clock is ahead."""
    unknowns = Unknowns(nominal)
    ahead_s = (float(values[unknowns.clock(camera)]) for camera in range(len(unknowns.names)))
    return tuple(each if abs(each) > _NOTHING else 0.0 for each in ahead_s)


def _lens_at(stated: Camera, lens: Array) -> Camera:
    if np.abs(lens).max() < _NOTHING:
        return stated
    focal_x, focal_y = np.array(stated.focal_px) * np.exp(lens[0])
    center_x, center_y = np.add(stated.center_px, lens[1:])
    return replace(
        stated, focal_px=(float(focal_x), float(focal_y)), center_px=(float(center_x), float(center_y))
    )
