"""The shaders of the installed pyrender are told what they shall be told."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from sim.rendering.pyrender_programs import LightCounts, with_gathered_shadows


def shader() -> str:
    found = find_spec("pyrender")
    assert found is not None and found.origin is not None
    return (Path(found.origin).parent / "shaders" / "mesh.frag").read_text()


def test_loops_over_lights_have_known_lengths() -> None:
    told = LightCounts(1, 3, 0, False).written_into(shader())
    assert [told.count(f"i < {count};") for count in (1, 3, 0)] == [1, 1, 1]
    assert not any(f"i < n_{kind}_lights" in told for kind in ("directional", "spot", "point"))


def test_shadows_are_gathered() -> None:
    told = with_gathered_shadows(shader())
    assert told.startswith("#version 330 core\n#extension GL_ARB_texture_gather")
    assert told.count("float PCF(") == 1 and told.count("textureGather(") == 1


def test_a_shader_in_other_words_stays_as_it_is() -> None:
    other = shader().replace("float PCF(", "float mean_of_nine(")
    assert with_gathered_shadows(other) == other
