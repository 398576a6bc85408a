"""What programs write to the terminal."""


class Terminal:
    """Counts the characters written, so that output is bounded."""

    __slots__ = ("characters",)

    def __init__(self, characters: int = 0) -> None:
        """Start with an empty screen."""
        self.characters = characters

    def wrote(self, text: str) -> None:
        """Count a text."""
        self.characters += len(text)

    def copy(self) -> "Terminal":
        """Return an independent copy."""
        return Terminal(self.characters)
