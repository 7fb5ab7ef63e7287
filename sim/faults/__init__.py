"""What goes wrong between sensor and recording."""
