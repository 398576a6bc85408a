"""The page of the manual about personal data names all that a server keeps, and nothing else."""

import re
import sqlite3

from tests.places import ROOT
from vrts.live.personal.export import ROWS
from vrts.live.store.migrations import migrate

PAGE = (ROOT / "vrts/manual/understand/personal-data.md").read_text("utf-8")
PERSONAL, _, OTHER = PAGE.partition("## Not personal")


def columns() -> set[str]:
    connection = sqlite3.connect(":memory:", isolation_level=None)
    migrate(connection)
    tables = connection.execute("SELECT name FROM sqlite_master WHERE type='table'").fetchall()
    found = {
        f"{table}.{row[1]}"
        for (table,) in tables
        for row in connection.execute(f"PRAGMA table_info({table})")
    }
    connection.close()
    return found


def named(text: str) -> list[str]:
    tables = {column.partition(".")[0] for column in columns()}
    found = re.findall(r"`([a-z_]+\.[a-z_]+)`", text)
    return [name for name in found if name.partition(".")[0] in tables]


def test_every_column_is_named_once_as_personal_or_not() -> None:
    assert sorted(named(PAGE)) == sorted(columns()), "say on the page what is kept, and how long"


def test_what_is_personal_of_somebody_is_handed_out() -> None:
    personal = {name.partition(".")[0] for name in named(PERSONAL)}
    of_rooms = {"room", "log", "log_head", "log_accepted"}  # records go with `log_text`
    assert personal - of_rooms == set(ROWS)


def test_all_that_browsers_keep_is_named() -> None:
    sources = [path.read_text("utf-8") for path in (ROOT / "vrts/web/live").rglob("*.js")]
    using = [text for text in sources if re.search(r"(local|session)Storage", text)]
    keys = {key.strip() for text in using for key in re.findall(r"[\"`](vrts [a-z ]*)", text)}
    assert {key for key in keys if f"`{key}`" not in PAGE} <= {"vrts"}
