"""Settings of a window's calibration."""

from __future__ import annotations

from estimator.align import AlignConfig
from estimator.config import Config
from estimator.corridor_config import CorridorConfig
from estimator.factors import GraphConfig
from estimator.handover import HandoverConfig
from estimator.loss import Loss
from estimator.ranges import AngleRad, LengthM, PositiveShare, RepeatCount, SearchRad, SigmaPx
from estimator.sighting_noise import SightingNoise
from estimator.window_result import ResultConfig


class WindowConfig(Config):
    """Noise, limits and search ranges of a window's calibration."""

    track_sigma_px: SigmaPx = 0.5
    sighting_noise: SightingNoise = SightingNoise()
    repeats: RepeatCount = 0  # how often sightings are measured again from a better scene
    unsure_rad: AngleRad = 0.006
    wide_search_rad: SearchRad = 0.04
    narrow_search_rad: SearchRad = 0.008
    scale_drift: PositiveShare = 0.01  # relative, of the odometry from one window to the next
    road_tolerance_m: LengthM = 0.08
    corridor: CorridorConfig = CorridorConfig()
    result: ResultConfig = ResultConfig()
    graph: GraphConfig = GraphConfig()
    rough_graph: GraphConfig = GraphConfig(road_sigma_m=0.08)  # pavements count as road
    handover: HandoverConfig = HandoverConfig()
    align: AlignConfig = AlignConfig()

    @property
    def fine_losses(self) -> tuple[Loss, Loss]:
        """The losses that measured-again sightings are adjusted with, one after the other."""
        return Loss(0.5), self.sighting_noise.loss
