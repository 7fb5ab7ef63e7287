"""The car: physics, driver, cameras on it and how they move, inertial and wheel sensors."""
