"""Post-processors: one module for each language that a program can be written in anew."""
