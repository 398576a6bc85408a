"""A class on one page, for those who mark."""
