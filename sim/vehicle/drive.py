"""What is asked of a drive: how far, how fast, in which manner, on how slippery a road."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from estimator.config import Config

Profile = Literal["steady", "pull_away", "stop_and_go", "crawl", "hard_braking"]


class DriveConfig(Config):
    """Speed, length, manner and bundle rate of a drive.

    Attributes:
        speed_mps: Cruising speed; bends are taken slower where ``lateral_mps2`` asks for it.
        distance_m: Distance driven between the first bundle and the last.
        rate_hz: Bundles a second.
        profile: ``steady`` rolls from the first moment on; ``pull_away`` starts at a standstill;
            ``stop_and_go`` stops again and again; ``crawl`` gropes along as one does when parking;
            ``hard_braking`` stops as hard as the tyres allow after three fifths of the way, and drives on.
        reverse: Drive backwards, from the far end of the distance to the start of the route.
        grip: Coefficient of friction: 1 dry, 0.5 wet, 0.3 snow, 0.1 ice.
        lateral_mps2: Highest acceleration in bends that is planned. By default what passengers like, and less
            where the road does not give it; a number is obeyed even if the car then slides.
    """

    speed_mps: float = Field(5.0, ge=0.2, le=40.0)
    distance_m: float = Field(50.0, gt=0.0, le=20_000.0)
    rate_hz: float = Field(10.0, ge=1.0, le=60.0)
    profile: Profile = "steady"
    reverse: bool = False
    grip: float = Field(1.0, ge=0.1, le=1.2)
    lateral_mps2: float | None = Field(None, ge=0.2, le=12.0)

    @property
    def bundle_count(self) -> int:
        """Bundles at both ends of a drive that nothing slows; its plan knows how many there will be."""
        return int(self.distance_m / self.speed_mps * self.rate_hz + 1e-6) + 1

    def time_s(self, index: int) -> float:
        """Return when bundle ``index`` is taken, since the drive began."""
        return index / self.rate_hz
