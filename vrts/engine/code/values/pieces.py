"""Pieces of strings: $DECODE, $UNPACK and PACK on values.

See [manual language/strings#decode, language/strings#pack].
"""

ELEMENT = 128  # characters of an element of a string array that PACK and $UNPACK count through


def decode(text: str, breaks: str, mode: int) -> tuple[str, str]:
    """Return the next piece of a string and what is left of it.

    Mode 0 takes the characters before the first break character, a mode above 0 the run of break
    characters at the start.
    """
    end = 0
    while end < len(text) and (text[end] in breaks) is (mode > 0):
        end += 1
    return text[:end], text[end:]


def packed(text: str, first: int, length: int, part: str) -> str:
    """Return a string with `length` characters from `first` (from 1) taken from another.

    A part that is too short is filled with blanks, as is a string that ends before `first`.
    """
    before = text[: first - 1].ljust(first - 1)
    return before + part[:length].ljust(length) + text[first - 1 + length :]


def spread(first: int, length: int) -> list[tuple[int, int, int]]:
    """Return element, first character (from 1) and length of each piece of a string array."""
    found: list[tuple[int, int, int]] = []
    at = first - 1
    while length > 0:
        element, offset = divmod(at, ELEMENT)
        taken = min(length, ELEMENT - offset)
        found.append((element, offset + 1, taken))
        at += taken
        length -= taken
    return found
