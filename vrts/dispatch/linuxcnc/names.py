"""Names and numbers as G-code spells them."""

LONGEST = 240  # characters of a line; LinuxCNC takes 255


def plain(name: str) -> str:
    """Return a name of VAL-II, without its sigil, as O-words and parameters take it."""
    return name.lstrip("#$").replace(".", "_").lower()


def number(value: float) -> str:
    """Return a number as G-code takes it: no exponent, and a negative one in brackets."""
    text = f"{value:.9f}".rstrip("0").rstrip(".")
    if text in ("", "-0"):
        text = "0"
    return f"[{text}]" if text.startswith("-") else text


def comment(text: str) -> str:
    """Return a line of the program as a comment that nothing acts on."""
    ascii_only = text.encode("ascii", "replace").decode().replace("\t", " ").rstrip()
    return f"; {ascii_only}"[:LONGEST]


def printed(text: str) -> str:
    """Return words as they may stand inside of a message."""
    ascii_only = text.encode("ascii", "replace").decode()
    return (
        ascii_only.replace("(", "[").replace(")", "]").replace("#", "no. ").replace("%", " percent")
    )
