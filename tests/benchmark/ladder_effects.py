"""Every severity there is, and what climbing it must do to an image: said here, before it is measured.

``falls``, ``rises`` and ``keeps`` name statistics of ``eval.likeness_statistics``, of
``tests.benchmark.true_tracks`` and the two that ``tests.benchmark.ladders`` adds. Not named is what an effect
moves by chance, or both ways by its nature: corners of GFTT are counted against the best one of the image, so
their number rises when all corners get weaker; the share of KLT tracks that survive rises when hard edges of
shadows, which are hard to follow, go, and what dirt, drops and JPEG bring into an image survives in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

_TEXTURE = ("contrast_std", "gradient_mean", "fast20_per_100kpx")
_SURVIVAL = ("klt_survival_1", "klt_survival_5")
_TRUE = ("true_share_1", "true_share_5")
_SEVERITIES = (0.0, 1.0, 2.0, 3.0, 4.0, 5.0)
ROADSIDE = (81, 320)  # rows without sky and bonnet, as the real drives are measured


@dataclass(frozen=True)
class Effect:
    """One ladder.

    Attributes:
        knob: Path of the setting.
        why: What it does to images, for the reader of the table.
        falls, rises: Statistics that must not go the other way at any step.
        keeps: Statistics that must stay as they are.
        values: Of the knob.
        settings: Other settings of the scenario.
        rows, columns: What of the image counts.
        from_s: When the first frame is taken.
        frames: How many.
    """

    knob: str
    why: str
    falls: tuple[str, ...] = ()
    rises: tuple[str, ...] = ()
    keeps: tuple[str, ...] = ()
    values: tuple[float, ...] = _SEVERITIES
    settings: tuple[str, ...] = ()
    rows: tuple[int, int] = ROADSIDE
    columns: tuple[int, int] = (0, 640)
    from_s: float = 0.5
    frames: int = 16

    @property
    def name(self) -> str:
        """The knob's own."""
        return self.knob.rpartition(".")[2]

    @property
    def is_of_the_sensor(self) -> bool:
        """Whether the world itself stays the same."""
        return self.knob.startswith("sensor.")

    @property
    def is_of_the_shutter(self) -> bool:
        """Whether an image takes more than one picture of the world."""
        return self.knob in ("sensor.motion_blur", "sensor.rolling_shutter_s")

    def settings_at(self, value: float) -> list[str]:
        """Return what to lay over the scenario."""
        return [*self.settings, f"{self.knob}={value:g}"]


_IN_TUNNEL = ("street.kind=tunnel", "street.length_m=110", "drive.distance_m=60")
_CLOUDY = ("weather.overcast=5",)  # as fog and rain bring it: only what they do themselves is measured
_TO_SUN = ("weather.sun_elevation_deg=17", "weather.sun_azimuth_deg=8")

EFFECTS: Sequence[Effect] = (
    Effect(
        "weather.overcast",
        "the sun's share of the light goes, and shadows' edges with it; less light in all",
        falls=("mean_level", *_TEXTURE),
    ),
    Effect(
        "weather.dusk",
        "less and less light; what is left comes from a bright sky before a dark street",
        falls=("mean_level", *_TEXTURE),
    ),
    Effect(
        "weather.night",
        "fewer and fewer lamps: ever more of the image is black, what is lit lies before the car",
        falls=("mean_level", "gradient_mean", "fast20_per_100kpx"),
        rises=("textureless_share",),
    ),
    Effect(
        "weather.tunnel",
        "daylight and lamps go, walls turn black",
        falls=("mean_level", "fast20_per_100kpx", "gradient_mean"),
        settings=_IN_TUNNEL,
        from_s=2.5,
    ),
    Effect(
        "weather.fog",
        "air between the camera and all that is far",
        falls=(*_TEXTURE, *_SURVIVAL),
        settings=_CLOUDY,
    ),
    Effect(
        "weather.rain",
        "a dark road against bright air, and streaks that stay nowhere",
        falls=_TEXTURE,
        rises=("textureless_share",),
        settings=_CLOUDY,
    ),
    Effect(
        "weather.wet_lens",
        "drops that blur what lies behind, and stay while the world moves",
        falls=("fast20_per_100kpx", "gradient_mean", *_SURVIVAL, *_TRUE),
    ),
    Effect(
        "weather.flare",
        "a veil over what is near the sun, until it is white",
        falls=("gradient_mean", "fast20_per_100kpx", "contrast_std"),
        rises=("mean_level",),
        settings=_TO_SUN,
        rows=(0, 200),
        columns=(170, 370),
    ),
    Effect(
        "sensor.blur",
        "every point becomes a disc, which reaches over what is plain as well",
        falls=(*_TEXTURE, "spectrum_slope", *_TRUE),
        rises=("shift_px",),
    ),
    Effect(
        "sensor.motion_blur",
        "what moves becomes a stripe, near things and those at the rim first, and reaches over what is plain",
        falls=(*_TEXTURE, "spectrum_slope"),
        frames=12,
    ),
    Effect(
        "sensor.rolling_shutter_s",
        "rows are taken one after another: shapes lean, but as sharp as before",
        rises=("shift_px",),
        keeps=("gradient_mean", "fast20_per_100kpx", "contrast_std"),
        frames=12,
        values=(0.0, 0.01, 0.02, 0.03, 0.04, 0.05),
    ),
    Effect(
        "sensor.vignetting",
        "corners lose light and texture",
        falls=("mean_level", "gradient_mean", "fast20_per_100kpx"),
    ),
    Effect(
        "sensor.dirt",
        "soft spots that hide the world, and stay while it moves",
        falls=("fast20_per_100kpx", "gradient_mean", *_SURVIVAL, *_TRUE),
        rises=("shift_px",),
    ),
    Effect(
        "sensor.jpeg",
        "fine texture is left out, then blocks show, whose corners stay while the world moves",
        falls=("spectrum_slope",),
        rises=("fast20_per_100kpx", "shift_px"),
    ),
    Effect(
        "sensor.noise",
        "corners that are nowhere",
        falls=("textureless_share", *_SURVIVAL, *_TRUE),
        rises=("fast20_per_100kpx", "gradient_mean", "shift_px"),
        values=(0.0, 1.0, 2.0, 4.0, 8.0, 16.0),
    ),
)
