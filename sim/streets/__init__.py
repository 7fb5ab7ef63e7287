"""Where things are: the road network, its ground, its houses and everything that stands along it."""
