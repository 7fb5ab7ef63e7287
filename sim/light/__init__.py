"""Light and weather: sun, sky, night, fog, rain."""
