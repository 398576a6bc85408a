"""What readers of binary logs raise."""


class Unreadable(Exception):  # noqa: N818 -- names what it is
    """A file cannot be read; says why, as what follows `it`."""
