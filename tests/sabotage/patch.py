"""One fault put into the product on purpose."""

from typing import NamedTuple


class Patch(NamedTuple):
    """Replace `before`, which stands once in `file`, by `after`; one of `tests` must fail."""

    name: str
    file: str
    before: str
    after: str
    tests: tuple[str, ...]
