"""Who is meant by a name, and where a name stands in words."""

import json
import re
from typing import Final

import msgspec

from vrts.live.names import display_name
from vrts.live.people.naming import person_name
from vrts.live.store.database import Connection

SHORT: Final = 3  # characters: shorter names are looked for as words of the server only
GONE: Final = "(purged)"  # in place of a name
_WHO: Final = (  # where somebody's account stands beside the name
    "SELECT id FROM account WHERE name=?",
    "SELECT account FROM log_name WHERE name=?",
    "SELECT account FROM chat WHERE account NOT NULL AND name=?",
    "SELECT account FROM program_version WHERE account NOT NULL AND saver=?",
)


class Names:
    """All spellings of the name of a person."""

    def __init__(self, given: str) -> None:
        """Take a name as somebody types it."""
        self.all = tuple(sorted({given, person_name(given), display_name(given)} - {""}))
        self.short = max(map(len, self.all), default=0) < SHORT
        self._word = re.compile(
            "|".join(rf"(?<!\w){re.escape(spelling)}(?!\w)" for spelling in self.written)
        )

    @property
    def written(self) -> tuple[str, ...]:
        """The spellings as they stand in texts, in those of JSON too."""
        quoted = (msgspec.json.encode(name).decode()[1:-1] for name in self.all)
        return tuple(sorted({*self.all, *quoted}, key=len, reverse=True))

    @property
    def as_json(self) -> str:
        """The spellings, for `json_each`."""
        return json.dumps(self.all)

    def stands_in(self, text: str) -> bool:
        """Return whether the name is a word of a text."""
        return bool(self.all) and self._word.search(text) is not None

    def without(self, text: str) -> str:
        """Return a text without the name."""
        return self._word.sub(GONE, text) if self.all else text


def accounts_of(connection: Connection, names: Names) -> list[int]:
    """Return all accounts that have or had a name, those that are gone too."""
    found: set[int] = set()
    for query in _WHO:
        for name in names.all:
            found.update(row[0] for row in connection.execute(query, (name,)))
    return sorted(found)
