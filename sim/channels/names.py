"""The truth channels that a world's settings may ask for."""

from __future__ import annotations

from typing import Literal

TruthChannel = Literal["depth", "segmentation", "optical_flow", "visibility"]
