"""Which programs of a class are alike, and where: for a person to look at, never a verdict."""
