"""The world: a MuJoCo car with cameras on procedurally generated streets. Truth lives here."""

from sim.rendering.gl import choose_backend

choose_backend()  # MuJoCo binds its OpenGL when it is imported, so the choice comes before every other module
