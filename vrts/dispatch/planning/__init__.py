"""A program verified as a controller will hold it: refusals, margins, the operator's sheet."""
