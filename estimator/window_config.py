"""Settings of a window's calibration."""

from __future__ import annotations

from estimator.align import AlignConfig
from estimator.config import Config
from estimator.factors import GraphConfig
from estimator.handover import HandoverConfig
from estimator.window_result import ResultConfig


class WindowConfig(Config):
    """Noise, limits and search ranges of a window's calibration."""

    track_sigma_px: float = 0.5
    anchored_sigma_px: float = 0.65
    unsure_rad: float = 0.006
    wide_search_rad: float = 0.04
    narrow_search_rad: float = 0.008
    scale_sigma: float = 0.03
    road_tolerance_m: float = 0.08
    result: ResultConfig = ResultConfig()
    graph: GraphConfig = GraphConfig()
    rough_graph: GraphConfig = GraphConfig(road_sigma_m=0.08)  # pavements count as road
    handover: HandoverConfig = HandoverConfig()
    align: AlignConfig = AlignConfig()
