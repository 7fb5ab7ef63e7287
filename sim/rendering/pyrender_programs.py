"""pyrender's shaders, told what never changes in a world, so that software does not reckon what nobody sees.

Mesa's rasteriser takes no branches: a light that might be there costs as much as one that is, shadows and
all. Where another version of pyrender has other words, its shader
stays as it is, and is only slower.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from OpenGL import GL
from pyrender.constants import MAX_N_LIGHTS
from pyrender.light import DirectionalLight, SpotLight
from pyrender.shader_program import ShaderProgram, ShaderProgramCache

# Its mean of nine interpolated comparisons reads 36 texels, of which 16 differ. Four gathers give the same.
_PCF = re.compile(r"float PCF\(.*?\n\}\n", re.DOTALL)
_GATHERED_PCF = """
vec4 occludes(sampler2D depths, vec2 corner, float compare) {
    return vec4(lessThan(textureGather(depths, corner), vec4(compare)));
}

float PCF(sampler2D depths, vec2 size, vec2 uv, float compare){
    vec2 base = floor(uv * size + 0.5);
    vec2 f = uv * size + 0.5 - base, g = 1.0 - f;
    vec4 lb = occludes(depths, base / size, compare);
    vec4 rb = occludes(depths, (base + vec2(2.0, 0.0)) / size, compare);
    vec4 lt = occludes(depths, (base + vec2(0.0, 2.0)) / size, compare);
    vec4 rt = occludes(depths, (base + vec2(2.0, 2.0)) / size, compare);
    float result = dot(lb, vec4(g.x, 1.0, g.y, g.x * g.y)) + dot(rb, vec4(1.0, f.x, f.x * g.y, g.y))
        + dot(lt, vec4(g.x * f.y, f.y, 1.0, g.x)) + dot(rt, vec4(f.y, f.x * f.y, f.x, 1.0));
    return result / 9.0;
}
"""
_VERSION = "#version 330 core\n"
_GATHER = "#extension GL_ARB_texture_gather : require\n"


class LightCounts(NamedTuple):
    """How many lights of each kind shine on one point, at most as many as pyrender allows."""

    directional: int
    spot: int
    point: int
    are_chosen_by_node: bool

    @classmethod
    def of(cls, light_nodes: Sequence[Any]) -> LightCounts:
        """Count the lights of a scene; of more than pyrender allows each node gets the nearest."""
        directional = sum(isinstance(node.light, DirectionalLight) for node in light_nodes)
        spot = sum(isinstance(node.light, SpotLight) for node in light_nodes)
        point = len(light_nodes) - directional - spot
        most = max(directional, spot, point)
        directional, spot, point = (min(count, MAX_N_LIGHTS) for count in (directional, spot, point))
        return cls(directional, spot, point, most > MAX_N_LIGHTS)

    def written_into(self, shader: str) -> str:
        """Return a shader whose loops over lights have known lengths."""
        for kind in ("directional", "spot", "point"):
            shader = shader.replace(f"i < n_{kind}_lights", f"i < {getattr(self, kind)}")
        return shader


def with_gathered_shadows(shader: str) -> str:
    """Return a shader that compares with the same texels of the shadow map, each read once."""
    if not _PCF.search(shader) or _VERSION not in shader:
        return shader
    return _PCF.sub(_GATHERED_PCF, shader).replace(_VERSION, _VERSION + _GATHER)


class ThriftyProgram(ShaderProgram):  # type: ignore[misc]
    """A program that remembers where its variables are and what they hold."""

    def __init__(self, lights: LightCounts, gathers: bool, **files: Any) -> None:
        super().__init__(**files)
        self._lights, self._gathers = lights, gathers
        self._places: dict[str, int] = {}
        self._held: dict[str, Any] = {}

    def _load(self, shader_filename: str) -> str:
        shader = self._lights.written_into(super()._load(shader_filename))
        return with_gathered_shadows(shader) if self._gathers else shader

    def set_uniform(self, name: str, value: Any, unsigned: bool = False) -> None:
        held = value.tobytes() if isinstance(value, np.ndarray) else value
        if self._held.get(name) == held:
            return
        self._held[name] = held
        place = self._places.get(name)
        if place is None:
            place = self._places[name] = int(GL.glGetUniformLocation(self._program_id, name))
        if place >= 0:
            self._send(place, value)

    def _send(self, place: int, value: Any) -> None:
        if not isinstance(value, np.ndarray):
            (GL.glUniform1i if isinstance(value, int) else GL.glUniform1f)(place, value)
        elif value.ndim == 1:
            self._FUNC_MAP[len(value), "f"](place, 1, value.astype(np.float32))
        else:
            self._FUNC_MAP[value.shape](place, 1, GL.GL_TRUE, value)


class ThriftyPrograms(ShaderProgramCache):  # type: ignore[misc]
    """The programs of one OpenGL context and one world."""

    def __init__(self, lights: LightCounts) -> None:
        super().__init__()
        self._lights = lights
        count = int(GL.glGetIntegerv(GL.GL_NUM_EXTENSIONS))
        extensions = {GL.glGetStringi(GL.GL_EXTENSIONS, index) for index in range(count)}
        self._gathers = b"GL_ARB_texture_gather" in extensions

    def get_program(
        self,
        vertex_shader: str,
        fragment_shader: str,
        geometry_shader: str | None = None,
        defines: Any = None,
    ) -> ThriftyProgram:
        key = (vertex_shader, fragment_shader, geometry_shader, *sorted((defines or {}).items()))
        if key not in self._program_cache:
            paths = [
                file and str(Path(self.shader_dir) / file)
                for file in (vertex_shader, fragment_shader, geometry_shader)
            ]
            self._program_cache[key] = ThriftyProgram(
                self._lights,
                self._gathers,
                vertex_shader=paths[0],
                fragment_shader=paths[1],
                geometry_shader=paths[2],
                defines=defines,
            )
        program: ThriftyProgram = self._program_cache[key]
        return program
