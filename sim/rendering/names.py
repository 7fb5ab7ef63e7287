"""The names a world's settings may choose from: which renderer draws, and how finely."""

from __future__ import annotations

from typing import Literal

RendererName = Literal["classic", "filament", "pyrender"]
Quality = Literal["draft", "standard", "fine"]
