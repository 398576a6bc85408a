"""A page of the manual as the search knows it."""

from enum import Enum
from typing import NamedTuple


class Kind(Enum):
    """What a page is about; the value is the word for it in lists."""

    RECIPE = "do"
    WORD = "word"
    RULE = "look up"  # a section about the language or the robots
    BACKGROUND = "understand"
    MESSAGE = "message"  # a diagnostic code
    COMMAND = "command"


class Page(NamedTuple):
    """One page, or one section of a longer one."""

    name: str  # what to type behind `vrts manual`
    kind: Kind
    title: str
    text: str  # Markdown; of a word or a command: what it does, in one line
    keywords: str = ""  # what else people call it
    section: bool = False  # whether it is one of several of its page
    asked: tuple[str, ...] = ()  # what people type who want it

    @property
    def of(self) -> str:
        """Name of the page that it is a section of, or its own."""
        return self.name.partition("#")[0]
