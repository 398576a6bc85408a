"""Names, numbers and words as the languages of controllers take them."""


def plain(name: str) -> str:
    """Return a name of VAL-II, without its sigil, of letters, digits and `_`."""
    return name.lstrip("#$").replace(".", "_").lower()


def decimal(value: float) -> str:
    """Return a number without an exponent."""
    text = f"{value:.9f}".rstrip("0").rstrip(".")
    return "0" if text in ("", "-0") else text


def readable(text: str) -> str:
    """Return a line of the program as it may stand in a comment."""
    return text.encode("ascii", "replace").decode().replace("\t", " ").rstrip()


def printed(text: str) -> str:
    """Return words as they may stand inside of a message."""
    ascii_only = text.encode("ascii", "replace").decode()
    return (
        ascii_only.replace("(", "[").replace(")", "]").replace("#", "no. ").replace("%", " percent")
    )
