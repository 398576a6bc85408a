"""What was done in a session, as its log tells it and as it is handed to be done again."""

from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.live.actions import Rewind, Save
from vrts.live.session.channel.messages import Act, Done, Halt


class Entry(NamedTuple):
    """A line of the log; entries whose `Done.counts` is false may be left out."""

    at_s: float  # `Done.at_s`
    order: Act | Halt
    done: Done | None = None  # what became of it, if that is known

    @property
    def was_refused(self) -> bool:
        """Whether it was refused for want of history, of which a replay may know more."""
        asked = self.order.action if isinstance(self.order, Act) else None
        return isinstance(asked, Rewind | Save) and self.done is not None and not self.done.accepted


def write_entries(path: Path, entries: Iterable[Entry]) -> None:
    """Write what was done before."""
    path.write_bytes(b"".join(msgspec.json.encode(entry) + b"\n" for entry in entries))
