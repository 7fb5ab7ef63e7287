"""Settings of the online estimator."""

from __future__ import annotations

from estimator.config import Config
from estimator.front_end import FrontEndConfig
from estimator.ledger import LedgerConfig
from estimator.lens_config import LensConfig, Refine
from estimator.move_watch import MoveWatchConfig
from estimator.off_nominal import OffNominal
from estimator.watch import WatchConfig
from estimator.window_config import WindowConfig
from estimator.window_pace import PaceConfig


class OnlineConfig(Config):
    """Settings of the online estimator and of its parts."""

    front_end: FrontEndConfig = FrontEndConfig()
    window: WindowConfig = WindowConfig()
    pace: PaceConfig = PaceConfig()
    ledger: LedgerConfig = LedgerConfig()
    watch: WatchConfig = WatchConfig()
    moves: MoveWatchConfig = MoveWatchConfig()
    off_nominal: OffNominal = OffNominal()
    lens: LensConfig = LensConfig()
    refine: Refine = "none"
