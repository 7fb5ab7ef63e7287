"""How finely pictures are drawn: what each quality means to each renderer, written into the model.

A model carries its quality with it (``visual`` settings and custom fields), so a renderer needs nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco

from sim.rendering.names import Quality
from sim.rendering.view import FAR_M, NEAR_M

SHADOW_RADIUS_M = 56.0  # of what the sun's shadow map covers
_QUALITY_FIELD = "rigtrue.quality"
# Options of MuJoCo's Filament that it reads from custom fields of the model; 2 is soft shadows.
_FILAMENT_SOFT_SHADOWS = 2
_FILAMENT_TEXTS = {"filament.cg.tone_mapping": "linear"}  # clips highlights, as a sensor does


@dataclass(frozen=True)
class Sampling:
    """What a quality means.

    Attributes:
        multisamples: Of the OpenGL renderers, a pixel; 0 is one sample at the pixel's centre.
        shadow_map_px: Side of the sun's shadow map; 0 draws no shadows.
        supersamples: Filament pixels a side of one picture pixel; it has no multisampling off-screen.
        ambient_occlusion: Whether Filament darkens corners that see little sky.
    """

    multisamples: int
    shadow_map_px: int
    supersamples: int
    ambient_occlusion: bool


SAMPLINGS: dict[Quality, Sampling] = {
    "draft": Sampling(0, 0, 1, False),
    "standard": Sampling(4, 4096, 2, True),
    "fine": Sampling(8, 8192, 3, True),
}


def write_visual_settings(
    spec: mujoco.MjSpec, largest_px: tuple[int, int], quality: Quality = "standard"
) -> None:
    """Fix clip planes, buffer size and sampling; call once on the spec before it is compiled."""
    sampling = SAMPLINGS[quality]
    spec.stat.extent = 1.0  # MuJoCo scales the clip planes by this, which else follows the scene
    spec.visual.map.znear = NEAR_M
    spec.visual.map.zfar = FAR_M
    spec.visual.map.shadowclip = SHADOW_RADIUS_M
    spec.visual.quality.shadowsize = sampling.shadow_map_px
    spec.visual.quality.offsamples = sampling.multisamples
    spec.visual.global_.offwidth, spec.visual.global_.offheight = largest_px
    spec.add_numeric(name=_QUALITY_FIELD, data=[list(SAMPLINGS).index(quality)], size=1)
    spec.add_numeric(name="filament.ao.enabled", data=[float(sampling.ambient_occlusion)], size=1)
    spec.add_numeric(name="filament.shadows.type", data=[_FILAMENT_SOFT_SHADOWS], size=1)
    for name, text in _FILAMENT_TEXTS.items():
        spec.add_text(name=name, data=text)


def sampling_of(model: mujoco.MjModel) -> Sampling:
    """Return what ``write_visual_settings`` chose for a model; standard where it was never asked."""
    field = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_NUMERIC, _QUALITY_FIELD)
    if field < 0:
        return SAMPLINGS["standard"]
    return list(SAMPLINGS.values())[int(model.numeric_data[model.numeric_adr[field]])]
