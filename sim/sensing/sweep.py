"""Exposures that last: rolling shutter and motion blur, rendered from the pose of every instant.

Each image is a weighted sum of pictures taken during its exposure, only the rows that were open then. Rows
that a picture does not show at their very instant are moved there, exactly, by ``sim.sensing.drift``.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from estimator.camera import Camera
from sim.rendering.view import FAR_M, Renderer, View
from sim.sensing.atmosphere import Atmosphere
from sim.sensing.body_boxes import BodyBoxes
from sim.sensing.drift import Drift
from sim.sensing.face import DRIFT_MARGIN_PX, GreyImage
from sim.sensing.lens import Lens
from sim.sensing.shutter import Shutter, Slot, slot_count, slots
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam

_SKY_M = 0.9 * FAR_M
_PROBE_SCALE = 4  # the probe's pictures are this much smaller
_SHADOWS_STAND_S = 0.004  # a fast car's own comes 6 cm further meanwhile, three texels of the shadow map
_FASTEST_SHARE = 0.995  # of what is not sky moves slower than what the pictures are spaced for


class Sweep:
    """Takes all cameras' images over the time that their shutters are open.

    Attributes:
        pictures: How many were rendered for images so far, faces of a wide lens counted one by one.
    """

    def __init__(self, lenses: Mapping[str, Lens], atmosphere: Atmosphere) -> None:
        self._lenses, self._atmosphere = lenses, atmosphere
        self._boxes: BodyBoxes | None = None  # of the stage's model, once it is seen
        self.pictures = 0

    def take(
        self, stage: Stage, renderer: Renderer, shutters: Mapping[str, Shutter], time_s: float
    ) -> dict[str, GreyImage]:
        """Return each camera's light, its exposure centred on ``time_s``."""
        fastest_px_s = self._fastest_px_s(stage, renderer, time_s)
        counts = {name: slot_count(shutters[name], fastest_px_s[name]) for name in self._lenses}
        if not any(shutter.blur_s for shutter in shutters.values()):
            # Strips add up to one picture however many: taken together, they share what an instant costs.
            counts = dict.fromkeys(counts, max(counts.values()))
        parts: dict[float, list[tuple[str, Slot]]] = defaultdict(list)
        for name, lens in self._lenses.items():
            for slot in slots(shutters[name], lens.size_px[1], counts[name]):
                parts[slot.time_s].append((name, slot))
        lights = {name: np.zeros(lens.size_px[::-1], np.float32) for name, lens in self._lenses.items()}
        shadows_of: float | None = None
        for offset_s in sorted(parts):
            keep = shadows_of is not None and offset_s - shadows_of < _SHADOWS_STAND_S
            shadows_of = shadows_of if keep else offset_s
            for name, slot, light in self._instant(stage, renderer, time_s + offset_s, parts[offset_s], keep):
                lights[name][slot.first : slot.last] += light * slot.weights[:, None].astype(np.float32)
        return lights

    def _instant(
        self,
        stage: Stage,
        renderer: Renderer,
        time_s: float,
        parts: list[tuple[str, Slot]],
        keep_shadows: bool,
    ) -> list[tuple[str, Slot, GreyImage]]:
        """Return the light of the rows that each camera takes at an instant."""
        late = tuple(name for name, slot in parts if slot.delay_s.any())
        drift = self._drift(stage, time_s, late) if late else None
        data = stage.at(time_s)
        lenses = {name: self._lens_of(name, slot) for name, slot in parts}
        views: dict[str, View] = {}
        for name, lens in lenses.items():
            views |= lens.views(name, world_from_cam(data, name))
        self.pictures += len(views)
        with_depth = bool(late) or self._atmosphere.needs_depth
        pictures = renderer.render(data, views, with_depth, keep_shadows)
        taken = []
        for name, slot in parts:
            lens, keys = lenses[name], lenses[name].keys(name)
            lights = [self._atmosphere.light(pictures[key], views[key], name, time_s) for key in keys]
            rates = None
            if drift is not None and name in late:
                rates = [
                    drift.pixel_rates(name, views[key], face.cam_from_face, pictures[key].depth_m)
                    for key, face in zip(keys, lens.faces, strict=True)
                ]
            taken.append((name, slot, lens.apply(lights, rates, slot.delay_s)))
        return taken

    def _drift(self, stage: Stage, time_s: float, cameras: tuple[str, ...]) -> Drift:
        if self._boxes is None:
            self._boxes = BodyBoxes(stage.at(time_s).model)
        return Drift(stage, time_s, cameras, self._boxes)

    def _lens_of(self, name: str, slot: Slot) -> Lens:
        lens = self._lenses[name]
        if slot.delay_s.any():
            return lens.rows(slot.first, slot.last, DRIFT_MARGIN_PX)
        whole = slot.first == 0 and slot.last == lens.size_px[1]
        return lens if whole else lens.rows(slot.first, slot.last)

    def _fastest_px_s(self, stage: Stage, renderer: Renderer, time_s: float) -> dict[str, float]:
        """Return how fast nearly all of what each camera sees moves, from small pictures of the depth."""
        drift = self._drift(stage, time_s, tuple(self._lenses))
        data = stage.at(time_s)
        views: dict[str, View] = {}
        for name, lens in self._lenses.items():
            for key, view in lens.views(name, world_from_cam(data, name)).items():
                views[key] = replace(view, pinhole=_smaller(view.pinhole))
        pictures = renderer.render(data, views, depth=True, keep_shadows=True)
        fastest_px_s = {}
        for name, lens in self._lenses.items():
            speeds = [np.zeros(1)]
            for key, face in zip(lens.keys(name), lens.faces, strict=True):
                depth_m = pictures[key].depth_m
                assert depth_m is not None
                rates = drift.pixel_rates(name, views[key], face.cam_from_face, depth_m)
                speeds.append(_PROBE_SCALE * np.linalg.norm(rates, axis=-1)[depth_m < _SKY_M])
            fastest_px_s[name] = float(np.quantile(np.concatenate(speeds), _FASTEST_SHARE))
        return fastest_px_s


def _smaller(pinhole: Camera) -> Camera:
    """Return the same view in fewer pixels."""
    width, height = (max(length // _PROBE_SCALE, 1) for length in pinhole.size_px)
    scale = (width / pinhole.size_px[0], height / pinhole.size_px[1])
    focal_px = (pinhole.focal_px[0] * scale[0], pinhole.focal_px[1] * scale[1])
    center_px = tuple((c + 0.5) * s - 0.5 for c, s in zip(pinhole.center_px, scale, strict=True))
    return Camera("pinhole", (width, height), focal_px, (center_px[0], center_px[1]))
