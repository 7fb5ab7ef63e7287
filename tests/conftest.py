"""Choose OpenGL before any test imports MuJoCo, which binds it once and for all."""

import sim  # noqa: F401
