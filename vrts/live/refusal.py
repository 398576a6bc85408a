"""A message that is not obeyed."""


class NotObeyed(Exception):  # noqa: N818 -- names the situation
    """Why, in a word and in words."""

    def __init__(self, code: str, text: str, help_: str = "") -> None:
        """Keep what the sender is told."""
        super().__init__(text)
        self.code = code
        self.text = text
        self.help = help_
