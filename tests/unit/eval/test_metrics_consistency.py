"""Whether stated covariances are judged rightly."""

import numpy as np
import pytest
from scipy.stats import chi2

from estimator.estimate import CameraEstimate, Status
from eval.errors import stated_norm95
from eval.metric import Missing
from eval.metrics_consistency import consistency_metrics
from tests.unit.eval.tiny_run import (
    RIG,
    SIGMA,
    TRUE_POSES,
    camera_estimates,
    off_by,
    run_log,
    straight,
    truth_of,
)


def consistency(errors, covariance=SIGMA):
    path = straight(3)
    return consistency_metrics(
        run_log(path, final=camera_estimates(errors, covariance=covariance)), truth_of(path)
    )


def test_errors_of_one_sigma_in_every_axis_give_a_nees_of_one():
    one_sigma = np.sqrt(np.diag(SIGMA))
    values = consistency({"left": one_sigma, "rear": -one_sigma})
    assert values["consistency.nees"] == pytest.approx(1.0)
    assert values["consistency.coverage95"] == 1.0


def test_covariances_nine_times_too_small_show_as_a_nees_of_nine():
    one_sigma = np.sqrt(np.diag(SIGMA))
    assert consistency({"left": one_sigma, "rear": one_sigma}, SIGMA / 9)[
        "consistency.nees"
    ] == pytest.approx(9.0)


def test_coverage_counts_the_cameras_inside_the_region_of_six_freedoms():
    edge_mm = 10 * np.sqrt(chi2.ppf(0.95, 6))
    values = consistency({"left": off_by(0, 0.999 * edge_mm), "rear": off_by(0, 1.001 * edge_mm)})
    assert values["consistency.coverage95"] == 0.5


def test_honest_errors_drawn_from_the_covariance_average_to_a_nees_of_one():
    rng = np.random.default_rng(3)
    root = rng.normal(size=(6, 6)) * np.array([1e-3] * 3 + [1e-2] * 3)[:, None]
    covariance = root @ root.T
    path, truth = straight(2), truth_of(straight(2))
    nees = []
    for _ in range(200):
        final = {
            # true = estimated.retract(e): the estimate is the truth perturbed by the inverse.
            name: CameraEstimate(
                pose @ type(pose).exp(root @ rng.normal(size=6)).inverse(), covariance, Status.CONVERGED
            )
            for name, pose in TRUE_POSES.items()
        }
        nees.append(consistency_metrics(run_log(path, final=final), truth)["consistency.nees"])
    assert np.mean(nees) == pytest.approx(1.0, abs=0.1)


def test_a_covariance_that_is_singular_is_named():
    value = consistency({}, np.zeros((6, 6)))["consistency.nees"]
    assert value == Missing("the pose of camera 'left' is not finite or its covariance not positive definite")


@pytest.mark.parametrize("sigmas", [(1, 1, 1), (3, 1, 0.2), (5, 0.1, 0.1)])
def test_the_stated_95_percent_radius_holds_95_percent_of_draws(sigmas):
    draws = np.random.default_rng(0).normal(size=(200_000, 3)) * sigmas
    inside = np.linalg.norm(draws, axis=1) < stated_norm95(np.diag(np.square(sigmas, dtype=float)))
    assert inside.mean() == pytest.approx(0.95, abs=0.01)


def test_the_reference_is_not_part_of_it():
    assert RIG.reference == "front"
    assert consistency({"front": off_by(50, 5000)})["consistency.nees"] == pytest.approx(0, abs=1e-9)
