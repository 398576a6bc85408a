"""Names as the controller keeps them."""

from vrts.base.diagnostic import Rule

NAME_TRUNCATED = Rule("V212", "name-truncated")

SIGNIFICANT = 15  # characters, the sigil not counted [manual language/names#length]


def key(name: str) -> str:
    """Return a name in lower case, cut to its significant characters, with its sigil."""
    name = name.lower()
    if len(name) <= SIGNIFICANT:
        return name
    return name[: SIGNIFICANT + 1] if name[0] in "$#" else name[:SIGNIFICANT]


def is_truncated(name: str) -> bool:
    """Return whether a name is longer than what counts."""
    return len(name) > SIGNIFICANT + (name[0] in "$#")


def as_string(name: str) -> str:
    """Return the name of a string variable for one of a number: `.x` of AS becomes `.$x`."""
    return f".${name[1:]}" if name.startswith(".") else f"${name}"
