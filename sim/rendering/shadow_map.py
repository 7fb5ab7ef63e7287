"""Let all cameras of one instant share one shadow map.

MuJoCo redraws the map for every picture. ``SharedShadowMap`` has it drawn once, then turns MuJoCo's further
drawing towards a scrap texture while the pictures go on reading the real one. The pixels are the same.

MuJoCo compares with the nearest texel and draws a fragment in full light or not at all, which makes stairs of
every edge. ``soften`` compares with the four around it and has the lit share multiply the light instead.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module

import mujoco

_SCRAP_PX = 8


def soften(context: mujoco.MjrContext) -> None:
    """Let light fade over one texel of the map; the context's OpenGL must be current.

    MuJoCo has the comparison answer with opacity, which its alpha test cuts. As luminance that goes into
    the colour, and the opacity is always 1.
    """
    gl = import_module("OpenGL.GL")
    gl.glBindTexture(gl.GL_TEXTURE_2D, context.shadowTex)
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_DEPTH_TEXTURE_MODE, gl.GL_LUMINANCE)
    for direction in (gl.GL_TEXTURE_MIN_FILTER, gl.GL_TEXTURE_MAG_FILTER):
        gl.glTexParameteri(gl.GL_TEXTURE_2D, direction, gl.GL_LINEAR)
    gl.glBindTexture(gl.GL_TEXTURE_2D, 0)


class SharedShadowMap:
    """The shadow framebuffer of one rendering context; that context's OpenGL must be current."""

    def __init__(self, context: mujoco.MjrContext) -> None:
        self._gl = import_module("OpenGL.GL")  # only now: it binds the platform that sim.rendering.gl chose
        self._context = context
        self._scrap = self._depth_texture()
        soften(context)

    @contextmanager
    def frozen(self) -> Iterator[None]:
        """Keep the map as it was drawn last; what casts shadows meanwhile is lost."""
        self._attach(self._scrap)
        try:
            yield
        finally:
            self._attach(self._context.shadowTex)

    def _attach(self, texture: int) -> None:
        gl = self._gl
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, self._context.shadowFBO)
        gl.glFramebufferTexture2D(gl.GL_FRAMEBUFFER, gl.GL_DEPTH_ATTACHMENT, gl.GL_TEXTURE_2D, texture, 0)
        mujoco.mjr_restoreBuffer(self._context)

    def _depth_texture(self) -> int:
        gl = self._gl
        texture = int(gl.glGenTextures(1))
        gl.glBindTexture(gl.GL_TEXTURE_2D, texture)
        gl.glTexImage2D(
            gl.GL_TEXTURE_2D,
            0,
            gl.GL_DEPTH_COMPONENT24,
            _SCRAP_PX,
            _SCRAP_PX,
            0,
            gl.GL_DEPTH_COMPONENT,
            gl.GL_FLOAT,
            None,
        )
        gl.glBindTexture(gl.GL_TEXTURE_2D, 0)
        return texture
