"""Numbers and comments as G-code spells them."""

from vrts.dispatch.saying.names import decimal, readable

LONGEST = 240  # characters of a line; LinuxCNC takes 255


def number(value: float) -> str:
    """Return a number as G-code takes it: no exponent, and a negative one in brackets."""
    text = decimal(value)
    return f"[{text}]" if text.startswith("-") else text


def comment(text: str) -> str:
    """Return a line of the program as a comment that nothing acts on."""
    return f"; {readable(text)}"[:LONGEST]
