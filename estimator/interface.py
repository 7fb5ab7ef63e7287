"""The door every estimator comes through, ours and a user's."""

from __future__ import annotations

from typing import Protocol

from estimator.bundle import FrameBundle
from estimator.estimate import Estimate
from estimator.rig import Rig


class Estimator(Protocol):
    """Anything that turns bundles into estimates. Constructed with the nominal rig and nothing else."""

    def update(self, bundle: FrameBundle) -> Estimate:
        """Take the next bundle, in order of stamps, and answer with the state of knowledge."""

    def close(self) -> Estimate:
        """Finish pending work and answer with the final estimate."""


class EstimatorFactory(Protocol):
    """What an entry point of ``rigtrue.estimators`` names: a class or function of the nominal rig."""

    def __call__(self, rig: Rig) -> Estimator: ...
