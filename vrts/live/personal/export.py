"""All that a server's folder holds of a person, as a zip that people and programs can read."""

import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any, Final, NamedTuple

import msgspec

from vrts.base.safe_names import safe
from vrts.live.personal.names import Names, accounts_of
from vrts.live.settings import DATABASE, SESSIONS
from vrts.live.store.database import Connection, read_only
from vrts.pipeline.files import CannotRead

ROWS: Final = {  # which rows of a table are of somebody; `:account` and `:names` are given
    "account": "id=:account",
    "attempt": "account=:account OR by=:account",
    "barred": "account=:account",
    "branch": "owner=:account",
    "browser": "account=:account",
    "chat": "account=:account OR reader=:account",
    "leads": "account=:account",
    "letter": "account=:account",
    "link": "name IN (SELECT value FROM json_each(:names)) AND NOT supervisor"
    " OR id=(SELECT link FROM account WHERE id=:account)",
    "log_name": "account=:account",
    "log_text": "account=:account",
    "login": "account=:account",
    "muted": "account=:account",
    "notice": "account=:account",
    "own_room": "owner=:account OR hand_by=:account",
    "person": "account=:account",
    "program_version": "account=:account OR shelf='own ' || :account",
    "slot": "account=:account",
}
SECRET: Final = frozenset(("password", "digest", "salt", "seal"))  # of no use to a person
_WITH_RECORDS: Final = (
    "SELECT log_text.room, room.name AS room_name, seq, log.session, log.at_s, log.wall, log.kind,"
    " log.accepted, log_text.text FROM log_text JOIN log USING (room, seq)"
    " LEFT JOIN room ON room.id=log_text.room WHERE log_text.account=:account"
    " ORDER BY log_text.room, seq"
)
README: Final = """\
What the server of vrts keeps of {name}
{line}

person.json        a list for each table of the database: accounts, log-ins, chat, who was muted or
                   sent away, announcements and stops, private rooms, names in rooms. Times are
                   seconds since 1970, UTC.
log.jsonl          every command that was recorded, with what became of it, one on a line
programs/          every version of every program that was saved in the page
files/             the files that the monitor has written, as they are now

Passwords, cookies, links and browsers are kept as digests, which tell nothing; they are left out,
and the rows say that they are there. What a session remembers of what was done in it, so that it
can be rewound, repeats the log. Backups, if somebody made some, hold the same as the database did
then.
"""


class Exported(NamedTuple):
    """What was handed out."""

    accounts: int  # that had the name
    records: int  # of logs
    programs: int  # versions of them
    files: int


def export(folder: Path, name: str, target: IO[bytes]) -> Exported:
    """Write all that is kept of a person as a zip; a server may run meanwhile.

    Args:
        folder: Of the server.
        name: Of the person.
        target: An open file.

    Raises:
        CannotRead: The database cannot be read.
    """
    names = Names(name)
    try:
        with read_only(folder / DATABASE) as connection:
            connection.execute("BEGIN")  # all of one moment
            accounts = accounts_of(connection, names)
            if not accounts:
                return Exported(0, 0, 0, 0)
            with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
                line = "=" * len(f"What the server of vrts keeps of {name}")
                archive.writestr("README.txt", README.format(name=name, line=line))
                person = {table: rows(connection, table, accounts, names) for table in ROWS}
                found = person.pop("program_version")
                person["programs"] = [{**row, "text": None} for row in found]
                person.pop("log_text")  # they are in the log
                text = msgspec.json.format(msgspec.json.encode(person), indent=2)
                archive.writestr("person.json", text)
                records = _log(connection, archive, accounts)
                programs = sum(_program(archive, row) for row in found)
                files = sum(_files(archive, folder, account) for account in accounts)
            return Exported(len(accounts), records, programs, files)
    except ValueError as problem:
        raise CannotRead(f"cannot read the database: {problem}") from problem


def rows(
    connection: Connection, table: str, accounts: list[int], names: Names
) -> list[dict[str, Any]]:
    """Return the rows of a table that are of a person, without secrets."""
    found: dict[tuple[Any, ...], dict[str, Any]] = {}
    for account in accounts:
        cursor = connection.execute(
            f"SELECT * FROM {table} WHERE {ROWS[table]}",  # noqa: S608 -- of ours
            {"account": account, "names": names.as_json},
        )
        columns = [column[0] for column in cursor.description]
        for row in cursor:
            shown = {
                column: "kept, not shown" if column in SECRET and value is not None else value
                for column, value in zip(columns, row, strict=True)
            }
            found[row] = shown
    return list(found.values())


def _log(connection: Connection, archive: zipfile.ZipFile, accounts: list[int]) -> int:
    """Write the records of a person; return how many there are."""
    count = 0
    with archive.open("log.jsonl", "w", force_zip64=True) as file:
        for account in accounts:
            cursor = connection.execute(_WITH_RECORDS, {"account": account})
            columns = [column[0] for column in cursor.description]
            for row in cursor:
                record = dict(zip(columns, row, strict=True))
                record["text"] = _json(record["text"])
                file.write(msgspec.json.encode(record) + b"\n")
                count += 1
    return count


def _json(text: object) -> object:
    """Return a text of JSON as what it holds, any other as it is."""
    try:
        return msgspec.json.decode(str(text))
    except msgspec.DecodeError:
        return text


def _program(archive: zipfile.ZipFile, row: dict[str, Any]) -> bool:
    if row["text"] is None:
        return False
    place = f"programs/{safe(row['shelf'])}/{safe(row['name'])}.{row['number']}.v2"
    archive.writestr(place, row["text"])
    return True


def _files(archive: zipfile.ZipFile, folder: Path, account: int) -> int:
    count = 0
    for file in _written(folder / SESSIONS, account):
        session, name = file.parent.parent.name, file.name
        archive.write(file, f"files/{safe(session)}/{name}")
        count += 1
    return count


def _written(sessions: Path, account: int) -> Iterator[Path]:
    for file in sorted(sessions.glob(f"*/p{account}/*")):
        if file.is_file() and not file.is_symlink():
            yield file
