"""Say how far each camera's estimate may be relied on."""

from __future__ import annotations

from estimator.belief import Belief
from estimator.config import Config
from estimator.estimate import Axes, Status
from estimator.off_nominal import OffNominal
from estimator.ranges import AngleRad, Count, LengthM, PositiveCount
from estimator.rig import Rig


class StatusConfig(Config):
    """What it takes to call a camera converged, or lost."""

    rotation_rad: AngleRad = 0.002
    translation_m: LengthM = 0.04
    min_links: Count = 30
    lost_after_bundles: PositiveCount = 20
    min_sightings: Count = 20


def is_lost(newest_sightings: int, missed_bundles: int, config: StatusConfig) -> bool:
    """Tell whether a camera gives no evidence any more: no images, or nothing recognised in them."""
    return missed_bundles >= config.lost_after_bundles or newest_sightings < config.min_sightings


def judge(
    name: str,
    belief: Belief,
    nominal: Rig,
    links: int,
    newest_sightings: int,
    missed_bundles: int,
    config: StatusConfig,
    observed: Axes,
    off_nominal: OffNominal,
) -> Status:
    """Return the status of an estimated camera once a window has been solved.

    Converged means: stated sigma small, every axis observed by the drive itself, enough sightings shared with
    other cameras, and an answer within a wide limit of the rig file. One beyond it comes from a rig file that
    belongs to another car, and is weak however small its sigma. What the prior makes unlikely within the
    limit is for ``PriorWatch`` to judge.

    Args:
        name: A camera other than the reference.
        belief: What is believed, with all that is stated of its uncertainty.
        nominal: The rig file.
        links: Sightings so far that this camera shares with others.
        newest_sightings: Sightings by this camera that the newest window believed.
        missed_bundles: How many bundles in a row came without its image.
        config: Thresholds.
        observed: Which axes the drive has made observable.
        off_nominal: The wide limit.
    """
    if is_lost(newest_sightings, missed_bundles, config):
        return Status.LOST
    from_nominal = nominal[name].ego_from_cam.local(belief.rig[name].ego_from_cam)
    sure = (
        belief.rotation_sigma_rad(name) < config.rotation_rad
        and belief.translation_sigma_m(name) < config.translation_m
        and all(observed)
        and links >= config.min_links
        and not off_nominal.is_beyond(from_nominal)
    )
    return Status.CONVERGED if sure else Status.WEAK
