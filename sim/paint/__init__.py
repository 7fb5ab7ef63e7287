"""What things are covered with: every texture, painted from a seed."""
