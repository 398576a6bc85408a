"""A session recorded as a command file: carried out again, it comes to the same places."""

from collections.abc import Callable

from vrts.debug.scripted.session import Done


class Recorder:
    """Writes each command that was carried out; refused ones as remarks."""

    def __init__(self, write: Callable[[str], None] | None, name: str = "") -> None:
        """Take what appends a line to the record; None: nothing is recorded.

        Args:
            write: Appends a line; it may raise OSError, as a full disk does.
            name: Of the record, as told where it cannot be written any more.
        """
        self._write = write
        self._name = name

    def add(self, done: Done) -> str:
        """Add a command; return what is to be said where the record ends here."""
        if self._write is None:
            return ""
        try:
            self._write(done.command if done.ok else f"# refused: {done.command}")
        except OSError as problem:
            self._write = None
            reason = (problem.strerror or "it failed").lower()
            return f"the record {self._name} ends here: {reason}"
        return ""
