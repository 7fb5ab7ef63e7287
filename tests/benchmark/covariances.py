"""How honest ways to state the covariance are: ``python -m tests.benchmark.covariances DRIVE:SEED``.

Prints e^T inv(Sigma) e / 6, the mean and each camera's, for the estimate that ``online`` ends with, under the
covariance of its graph and under sandwiches with one score a landmark.
"""

from __future__ import annotations

import sys

import numpy as np

from estimator.belief import Belief
from estimator.evidence import Evidence, Free, UsualErrors
from estimator.online import OnlineEstimator
from estimator.recording import Recording
from estimator.se3 import SE3, Array
from eval.truth import read_truth
from scenarios.load import load_scenario
from scenarios.recordings import cached_recording

NOBODY: frozenset[str] = frozenset()


def covariances(belief: Belief, evidence: Evidence) -> dict[str, Array]:
    """Return (6 C, 6 C) by name."""
    size = len(belief.covariance)
    found = {"graph": belief.covariance}
    for name, lenses in (("sandwich", NOBODY), ("sandwich, lenses free", frozenset(belief.rig.cameras))):
        posterior = evidence.posterior(UsualErrors(), Free(lenses, NOBODY))
        found[name] = posterior.covariance[:size, :size]
        found[f"{name}, x disagreement"] = found[name] * max(1.0, posterior.disagreement)
    return found


def nees(belief: Belief, covariance: Array, truth: dict[str, SE3]) -> Array:
    """Return (C,) of the estimated cameras, with the error of scale that a drive shares."""
    stated = Belief(belief.rig, covariance).with_scale_sigma(0.002)
    errors = {name: belief.rig[name].ego_from_cam.local(truth[name]) for name in belief.rig.estimated_names}
    return np.array(
        [e @ np.linalg.solve(stated.camera_covariance(name), e) / 6 for name, e in errors.items()]
    )


def main(drives: list[str]) -> None:
    """Run the online estimator over drives, ``scenario:seed``, and print a table."""
    for drive in drives:
        name, _, seed = drive.partition(":")
        scenario = load_scenario(name)
        with cached_recording(scenario, int(seed or 0), lambda done, total: None) as bag:
            estimator = OnlineEstimator(scenario.rig)
            stamp_ns = 0
            with Recording(bag, scenario.rig) as recording:
                for bundle in recording.bundles():
                    estimator.update(bundle)
                    stamp_ns = bundle.stamp_ns
            estimator.close()
            truth = dict(read_truth(bag).ego_from_cams_at(stamp_ns))  # type: ignore[union-attr]
        evidence = estimator._lens_watch._evidence
        for way, covariance in covariances(estimator.belief, evidence).items():
            values = nees(estimator.belief, covariance, truth)
            print(f"{drive:20s} {way:40s} {values.mean():6.2f}  {np.round(values, 2)}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:] or ["first_drive:0"])
