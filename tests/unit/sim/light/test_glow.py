"""What shines by itself: lamps of driving cars, lit windows, signals; street lamps only where they burn."""

import numpy as np

from sim.paint.car_lamps import car_lamp_glow
from sim.paint.furniture import furniture_glow
from sim.paint.furniture_parts import region
from sim.paint.lit_windows import light_windows
from sim.shapes.facade_plan import draw_facade
from sim.shapes.parked_cars import KINDS, body


def test_head_and_tail_lamps_of_every_car_shine_and_little_else() -> None:
    for seed in range(12):
        _, skin = body(KINDS[seed % len(KINDS)], np.random.default_rng(seed))
        glow = car_lamp_glow(skin.image)
        assert (glow > 200).sum() > 100
        assert 20 < np.median(glow[(glow > 0) & (glow < 100)]) < 60
        assert (glow > 0).mean() < 0.03


def test_some_windows_are_lit_and_the_wall_never() -> None:
    facade = draw_facade(12.0, np.random.default_rng(2))
    image = np.full((round(facade.height_m / 0.05), round(40 / 0.05), 3), 128, np.uint8)
    glow = light_windows(facade, image, 0.05, np.random.default_rng(3))
    assert 0 < (glow > 0).mean() < 0.3
    panes = [p for p in facade.panels if p.kind in ("window", "display")]
    row, column = np.argwhere(glow > 0)[0]
    x, z = (column + 0.5) * 0.05, facade.height_m - (row + 0.5) * 0.05
    assert any(p.x0 < x < p.x1 and p.z0 < z < p.z1 for p in panes) or x > facade.width_m


def test_signals_shine_by_themselves_and_street_lamps_do_not() -> None:
    glow = furniture_glow()
    height, width = glow.shape
    for name, shines in (("signal_red", True), ("signal_green", True), ("lamp", False)):
        u0, v0, u1, v1 = region(name)
        part = glow[int(v0 * height) : int(v1 * height), int(u0 * width) : int(u1 * width)]
        assert bool((part > 60).any()) is shines, name
