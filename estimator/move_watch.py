"""Watch whether cameras still sit where all the windows before said: a knock, a mount that gives way.

What is known after many windows is so firm that one window more hardly changes it, and whatever denies it
passes for outliers. So each window is also solved as if nothing had been known, and the two are compared.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from pydantic import Field

from estimator import move_findings as say
from estimator.belief import Belief
from estimator.config import Config
from estimator.finding import Finding
from estimator.ranges import SigmaM, SigmaRad
from estimator.se3 import Array
from estimator.window_again import adjust_again
from estimator.window_config import WindowConfig
from estimator.window_result import WindowResult


class MoveWatchConfig(Config):
    """When a window contradicts what was known, and how little is taken to be known where it does.

    ``chi2`` is 0.9999 of a chi-square with six degrees of freedom.
    """

    chi2: float = Field(27.9, gt=0, le=1e6)
    alone_rotation_rad: SigmaRad = 0.02  # a sigma for each axis
    alone_translation_m: SigmaM = 0.05

    def camera_covariance(self) -> Array:
        """Return the (6, 6) covariance of a camera of which next to nothing is known."""
        sigmas = np.repeat([self.alone_rotation_rad, self.alone_translation_m], 3)
        return np.diag(sigmas**2)


@dataclass(frozen=True)
class Examined:
    """A window's result without what moved cameras spoil.

    Attributes:
        result: What to believe of the window.
        moved: The cameras that two windows in a row now show somewhere else: known from this one alone.
    """

    result: WindowResult
    moved: frozenset[str] = frozenset()


class MoveWatch:
    """Remembers which cameras the newest windows contradicted, and where those showed them.

    Attributes:
        in_doubt: The cameras that the newest window contradicts, and whose place is not clear yet.
    """

    def __init__(self, config: MoveWatchConfig, window: WindowConfig, shared_scale_sigma: float) -> None:
        self._config = config
        self._shared_scale_sigma = shared_scale_sigma
        self._window = window
        self._shown: dict[str, Belief] = {}  # by camera in doubt: what the last window alone said
        self._window_began_ns = 0  # that window's first stamp
        self._moves: dict[str, Finding] = {}  # by camera: its last move
        self._doubts: tuple[Finding, ...] = ()
        self.in_doubt: frozenset[str] = frozenset()

    def findings(self) -> Iterator[Finding]:
        """Yield the contradictions that stand, and the moves of the drive."""
        yield from self._doubts
        yield from self._moves.values()

    def examine(self, before: Belief, result: WindowResult, blamed: frozenset[str]) -> Examined:
        """Compare a window with what was believed before it.

        Args:
            before: What was believed.
            result: The window, solved after it.
            blamed: Cameras whose lens or clock is in doubt: that changes their poses with the car's motion.

        Raises:
            RuntimeError: The window could not be solved by itself.
        """
        known = before.known_within(self._window.unsure_rad) - {before.rig.reference} - blamed
        alone = self._solve(result, before, frozenset(before.rig.estimated_names)) if known else None
        if alone is None:
            return Examined(result)
        stated = before.with_scale_sigma(self._shared_scale_sigma)
        odd = frozenset(n for n in known if distance(stated, alone.belief, n) > self._config.chi2)
        if 2 * len(odd) > len(before.rig.estimated_names):
            self._doubt(frozenset(), stated, alone.belief)
            self._doubts = (say.all_at_once(before.rig.reference, odd, len(before.rig.estimated_names)),)
            return Examined(result)
        return self._settle(odd, before, result)

    def _settle(self, odd: frozenset[str], before: Belief, result: WindowResult) -> Examined:
        again = self._solve(result, before, odd) if odd else None
        if again is None:
            self._doubt(frozenset(), before, result.belief)
            return Examined(result)
        moved = frozenset(n for n in odd & self._shown.keys() if self._agree(n, again.belief))
        for name in moved:
            self._moves[name] = say.moved(name, before, again.belief, self._window_began_ns)
        self._doubt(odd - moved, before, again.belief)
        self._window_began_ns = again.scene.stamps_ns[0]
        belief = again.belief.with_cameras_of(before, odd - moved)
        return Examined(replace(again, belief=belief), moved)

    def _solve(self, result: WindowResult, before: Belief, free: frozenset[str]) -> WindowResult | None:
        forgetful = before.forgetting(free, self._config.camera_covariance())
        return adjust_again(result, forgetful, self._window)

    def _agree(self, name: str, now: Belief) -> bool:
        return distance(self._shown[name], now, name) < self._config.chi2

    def _doubt(self, names: frozenset[str], before: Belief, now: Belief) -> None:
        self._doubts = tuple(say.contradicted(name, before, now) for name in sorted(names))
        self._shown = dict.fromkeys(names, now)
        self.in_doubt = names


def distance(one: Belief, other: Belief, name: str) -> float:
    """Return how far apart two independent beliefs see a camera, as a squared Mahalanobis distance."""
    step = one.rig[name].ego_from_cam.local(other.rig[name].ego_from_cam)
    covariance = one.camera_covariance(name) + other.camera_covariance(name)
    return float(step @ np.linalg.solve(covariance, step))
