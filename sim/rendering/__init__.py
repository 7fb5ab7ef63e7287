"""From a world to pictures: the renderers behind one protocol."""
