"""What moves besides the car: cars, cyclists, pedestrians."""
