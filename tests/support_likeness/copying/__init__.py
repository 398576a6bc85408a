"""What becomes of a program when another hands it in."""
