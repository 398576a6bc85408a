"""Results of a class in the formats of other systems: pure functions of what marking wrote."""
