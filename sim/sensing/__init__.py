"""From light to image: lens, shutter, exposure, noise."""
