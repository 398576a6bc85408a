"""A line while it is typed: editing keys, lines typed before, words completed."""

from collections.abc import Callable, Iterable

LONGEST = 500  # characters
MOST_KEPT = 200  # lines typed before

_WORD = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.$#-")


class Line:
    """The text, where the next character goes, and the lines typed before."""

    def __init__(
        self,
        text: str = "",
        before: Iterable[str] = (),
        words: Callable[[], Iterable[str]] = tuple,
    ) -> None:
        """Begin with a text; `words` gives what a word may become."""
        self.text = text
        self.at = len(text)
        self.offered: list[str] = []  # words that the last Tab found
        self._before = list(before)
        self._place = len(self._before)
        self._kept = text  # what was typed before looking at earlier lines
        self._words = words

    def press(self, key: str) -> None:
        """Take a key; one that means nothing here does nothing."""
        self.offered = []
        deed = _EDITING.get(key)
        if deed is not None:
            deed(self)
        elif len(key) == 1:
            self.insert(key)

    def insert(self, text: str) -> None:
        """Put characters where the next one goes: those that can be seen, as many as fit."""
        fit = "".join(c if c.isprintable() else " " for c in text)[: LONGEST - len(self.text)]
        self.text = self.text[: self.at] + fit + self.text[self.at :]
        self.at += len(fit)

    # --- keys ---------------------------------------------------------------------------------

    def left(self) -> None:
        """Go one character to the left."""
        self.at = max(self.at - 1, 0)

    def right(self) -> None:
        """Go one character to the right."""
        self.at = min(self.at + 1, len(self.text))

    def home(self) -> None:
        """Go to the beginning."""
        self.at = 0

    def end(self) -> None:
        """Go to the end."""
        self.at = len(self.text)

    def backspace(self) -> None:
        """Delete the character before."""
        self._cut(max(self.at - 1, 0), self.at)

    def delete(self) -> None:
        """Delete the character here."""
        self._cut(self.at, self.at + 1)

    def to_end(self) -> None:
        """Delete all that follows."""
        self._cut(self.at, len(self.text))

    def to_begin(self) -> None:
        """Delete all that stands before."""
        self._cut(0, self.at)

    def word(self) -> None:
        """Delete the word before."""
        begin = len(self.text[: self.at].rstrip())
        while begin > 0 and not self.text[begin - 1].isspace():
            begin -= 1
        self._cut(begin, self.at)

    def _cut(self, begin: int, end: int) -> None:
        self.text = self.text[:begin] + self.text[end:]
        self.at = begin

    def earlier(self) -> None:
        """Show the line that was typed before this one."""
        self._show(self._place - 1)

    def later(self) -> None:
        """Show the line that was typed after this one."""
        self._show(self._place + 1)

    def _show(self, place: int) -> None:
        if not 0 <= place <= len(self._before):
            return
        if self._place == len(self._before):
            self._kept = self.text
        self._place = place
        self.text = self._kept if place == len(self._before) else self._before[place]
        self.at = len(self.text)

    def complete(self) -> None:
        """Complete the word before as far as that is sure; offer words where there are several."""
        begin = self.at
        while begin > 0 and self.text[begin - 1] in _WORD:
            begin -= 1
        start = self.text[begin : self.at]
        found = sorted({word for word in self._words() if word.startswith(start)})
        if found:
            self.insert(_shared(found)[len(start) :])
        self.offered = found if len(found) > 1 else []


_EDITING: dict[str, Callable[[Line], None]] = {
    "left": Line.left,
    "right": Line.right,
    "home": Line.home,
    "end": Line.end,
    "c-a": Line.home,
    "c-e": Line.end,
    "backspace": Line.backspace,
    "delete": Line.delete,
    "c-k": Line.to_end,
    "c-u": Line.to_begin,
    "c-w": Line.word,
    "up": Line.earlier,
    "down": Line.later,
    "tab": Line.complete,
}


def _shared(words: list[str]) -> str:
    """Return how all of some words begin, sorted as they are."""
    first, last = words[0], words[-1]
    same = (k for k, (a, b) in enumerate(zip(first, last, strict=False)) if a != b)
    return first[: next(same, min(len(first), len(last)))]
