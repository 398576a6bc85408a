"""The tables, as numbered steps; a database says in `user_version` how many it has taken."""

import sqlite3
from collections.abc import Iterator
from typing import Final

STEPS: Final = (
    """
    CREATE TABLE account (
        id INTEGER PRIMARY KEY,
        name TEXT NOT NULL UNIQUE,
        password TEXT,
        supervisor INTEGER NOT NULL DEFAULT 0,
        room TEXT,
        created REAL NOT NULL
    );
    CREATE TABLE login (
        digest BLOB PRIMARY KEY,
        account INTEGER NOT NULL REFERENCES account ON DELETE CASCADE,
        expires REAL NOT NULL
    ) WITHOUT ROWID;
    CREATE TABLE link (
        digest BLOB PRIMARY KEY,
        supervisor INTEGER NOT NULL,
        room TEXT,
        name TEXT,
        uses INTEGER NOT NULL,
        expires REAL NOT NULL
    ) WITHOUT ROWID;
    CREATE TABLE room (
        id TEXT PRIMARY KEY,
        name TEXT NOT NULL,
        scene TEXT NOT NULL,
        place INTEGER NOT NULL,
        chat INTEGER NOT NULL DEFAULT 1,
        turn_s REAL NOT NULL DEFAULT 0,
        idle_s REAL NOT NULL,
        closed INTEGER NOT NULL DEFAULT 0
    );
    CREATE TABLE chat (
        room TEXT NOT NULL,
        number INTEGER NOT NULL,
        at REAL NOT NULL,
        account INTEGER,
        name TEXT NOT NULL,
        text TEXT NOT NULL,
        private INTEGER NOT NULL,
        reader INTEGER,
        PRIMARY KEY (room, number)
    );
    CREATE TABLE log (
        room TEXT NOT NULL,
        seq INTEGER NOT NULL,
        session INTEGER NOT NULL,
        at_s REAL NOT NULL,
        wall REAL NOT NULL,
        kind TEXT NOT NULL,
        accepted INTEGER NOT NULL,
        person BLOB NOT NULL,
        content BLOB NOT NULL,
        previous BLOB NOT NULL,
        hash BLOB NOT NULL,
        PRIMARY KEY (room, seq)
    );
    CREATE TABLE log_text (
        room TEXT NOT NULL,
        seq INTEGER NOT NULL,
        account INTEGER,
        salt BLOB NOT NULL,
        text TEXT NOT NULL,
        PRIMARY KEY (room, seq)
    );
    CREATE INDEX log_text_of ON log_text (account);
    CREATE TABLE log_name (
        room TEXT NOT NULL,
        account INTEGER NOT NULL,
        salt BLOB NOT NULL,
        name TEXT NOT NULL,
        PRIMARY KEY (room, account)
    );
    CREATE TRIGGER log_is_append_only BEFORE UPDATE ON log
        BEGIN SELECT RAISE(ABORT, 'the log is append-only'); END;
    CREATE TRIGGER log_is_kept BEFORE DELETE ON log
        BEGIN SELECT RAISE(ABORT, 'the log is append-only'); END;
    CREATE TABLE counter (name TEXT PRIMARY KEY, value INTEGER NOT NULL);
    """,
    """
    CREATE TABLE reached (
        room TEXT PRIMARY KEY,
        session INTEGER NOT NULL,
        time_s REAL NOT NULL,
        seq INTEGER
    ) WITHOUT ROWID;
    """,
    """
    CREATE TABLE barred (
        room TEXT NOT NULL,
        account INTEGER NOT NULL REFERENCES account ON DELETE CASCADE,
        name TEXT NOT NULL,
        PRIMARY KEY (room, account)
    ) WITHOUT ROWID;
    """,
    """
    CREATE TABLE branch (
        room TEXT PRIMARY KEY,
        owner INTEGER REFERENCES account ON DELETE SET NULL,
        origin TEXT NOT NULL,
        at_s REAL NOT NULL
    ) WITHOUT ROWID;
    """,
    """
    CREATE TABLE program_version (
        shelf TEXT NOT NULL,
        name TEXT NOT NULL,
        number INTEGER NOT NULL,
        at REAL NOT NULL,
        account INTEGER,
        saver TEXT NOT NULL,
        text TEXT,
        PRIMARY KEY (shelf, name, number)
    ) WITHOUT ROWID;
    CREATE INDEX program_version_of ON program_version (account);
    """,
    """
    ALTER TABLE link ADD COLUMN id TEXT NOT NULL DEFAULT '';
    ALTER TABLE link ADD COLUMN made REAL NOT NULL DEFAULT 0;
    ALTER TABLE link ADD COLUMN used INTEGER NOT NULL DEFAULT 0;
    ALTER TABLE link ADD COLUMN code INTEGER NOT NULL DEFAULT 0;
    ALTER TABLE link ADD COLUMN ended REAL;
    ALTER TABLE link ADD COLUMN away INTEGER NOT NULL DEFAULT 0;
    UPDATE link SET id=lower(hex(substr(digest, 1, 4)));
    -- class codes of before had 30 bits: they end, and a longer one is made
    UPDATE link SET code=1, ended=0 WHERE room IS NULL AND name IS NULL AND NOT supervisor;
    ALTER TABLE account ADD COLUMN link TEXT;
    ALTER TABLE account ADD COLUMN seen REAL NOT NULL DEFAULT 0;
    ALTER TABLE account ADD COLUMN stayed_s REAL NOT NULL DEFAULT 0;
    UPDATE account SET seen=created, stayed_s=86400;
    """,
    """
    CREATE TABLE browser (
        account INTEGER NOT NULL REFERENCES account ON DELETE CASCADE,
        digest BLOB NOT NULL,
        PRIMARY KEY (account, digest)
    ) WITHOUT ROWID;
    CREATE INDEX browser_of ON browser (digest);
    CREATE TABLE muted (
        account INTEGER PRIMARY KEY REFERENCES account ON DELETE CASCADE,
        name TEXT NOT NULL
    );
    """,
    """
    -- signs, made with a key that is not in the database: see `seals`
    CREATE TABLE log_head (
        room TEXT PRIMARY KEY,
        name TEXT NOT NULL,
        records INTEGER NOT NULL,
        last BLOB NOT NULL,
        seal BLOB NOT NULL
    ) WITHOUT ROWID;
    CREATE TABLE log_seal (
        one INTEGER PRIMARY KEY CHECK (one=1),
        database BLOB NOT NULL,
        key BLOB NOT NULL,
        count INTEGER NOT NULL,
        rooms INTEGER NOT NULL,
        heads BLOB NOT NULL,
        accepted INTEGER NOT NULL,
        seal BLOB NOT NULL
    );
    CREATE TABLE log_purged (
        room TEXT NOT NULL,
        seq INTEGER NOT NULL,
        at REAL NOT NULL,
        why TEXT NOT NULL,
        seal BLOB NOT NULL,
        PRIMARY KEY (room, seq)
    ) WITHOUT ROWID;
    CREATE TABLE log_accepted (
        number INTEGER PRIMARY KEY,
        at REAL NOT NULL,
        what TEXT NOT NULL,
        seal BLOB NOT NULL
    );
    ALTER TABLE log_name ADD COLUMN seal BLOB NOT NULL DEFAULT x'';
    """,
    """
    -- what everybody has to see: that an arm was stopped in a room, or, in no room, an announcement
    CREATE TABLE notice (
        room TEXT PRIMARY KEY,
        number INTEGER NOT NULL,
        at REAL NOT NULL,
        account INTEGER,
        name TEXT NOT NULL,
        text TEXT NOT NULL
    ) WITHOUT ROWID;
    """,
    """
    -- a course: who is on its lists, which rooms assistants lead, and what was handed in
    CREATE TABLE person (
        account INTEGER PRIMARY KEY REFERENCES account ON DELETE CASCADE,
        key TEXT NOT NULL UNIQUE,
        email TEXT NOT NULL,
        ids TEXT NOT NULL,
        rank TEXT NOT NULL,
        team TEXT NOT NULL DEFAULT '',
        subject TEXT UNIQUE,
        listed INTEGER NOT NULL DEFAULT 1,
        called TEXT NOT NULL DEFAULT '',
        origin TEXT NOT NULL DEFAULT 'file',
        rooms TEXT NOT NULL DEFAULT '[]'
    );
    CREATE TABLE letter (
        account INTEGER PRIMARY KEY REFERENCES account ON DELETE CASCADE,
        digest BLOB NOT NULL UNIQUE,
        made REAL NOT NULL,
        expires REAL NOT NULL
    );
    CREATE TABLE leads (
        account INTEGER NOT NULL REFERENCES account ON DELETE CASCADE,
        room TEXT NOT NULL,
        PRIMARY KEY (account, room)
    ) WITHOUT ROWID;
    CREATE TABLE attempt (
        account INTEGER NOT NULL REFERENCES account ON DELETE CASCADE,
        assignment TEXT NOT NULL,
        number INTEGER NOT NULL,
        at REAL NOT NULL,
        by INTEGER REFERENCES account ON DELETE SET NULL,
        digest TEXT NOT NULL,
        state TEXT NOT NULL,
        mark TEXT,
        total TEXT,
        late TEXT NOT NULL DEFAULT '',
        said TEXT NOT NULL DEFAULT '',
        causes TEXT NOT NULL DEFAULT '[]',
        PRIMARY KEY (account, assignment, number)
    ) WITHOUT ROWID;
    CREATE INDEX attempt_of ON attempt (assignment);
    CREATE TABLE own_room (
        room TEXT PRIMARY KEY,
        owner INTEGER REFERENCES account ON DELETE SET NULL,
        team TEXT NOT NULL DEFAULT '',
        assignment TEXT NOT NULL DEFAULT '',
        hand_at REAL NOT NULL DEFAULT 0,
        hand_by INTEGER REFERENCES account ON DELETE SET NULL,
        hand_text TEXT NOT NULL DEFAULT ''
    ) WITHOUT ROWID;
    CREATE INDEX own_room_of ON own_room (owner);
    CREATE TABLE slot (
        room TEXT NOT NULL,
        starts REAL NOT NULL,
        ends REAL NOT NULL,
        account INTEGER NOT NULL REFERENCES account ON DELETE CASCADE,
        PRIMARY KEY (room, starts)
    ) WITHOUT ROWID;
    CREATE INDEX slot_of ON slot (account);
    """,
    """
    -- tasks that are another one for each student: by which a program was handed in, a room goes
    ALTER TABLE attempt ADD COLUMN variant TEXT NOT NULL DEFAULT '';
    ALTER TABLE own_room ADD COLUMN variant TEXT NOT NULL DEFAULT '';
    ALTER TABLE branch ADD COLUMN variant TEXT NOT NULL DEFAULT '';
    """,
)


class TooNew(Exception):  # noqa: N818 -- names the situation
    """The database was written by a later vrts."""


class NotMigrated(Exception):  # noqa: N818 -- names the situation
    """A step failed: the database is as it was."""


def version_of(connection: sqlite3.Connection) -> int:
    """Return how many steps a database has taken; 0: it is empty, or none of vrts."""
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    return int(version)


def migrate(connection: sqlite3.Connection, steps: tuple[str, ...] = STEPS) -> int:
    """Bring a database to the present tables, in one transaction: all steps or none.

    Returns:
        How many steps were taken.

    Raises:
        TooNew: The database has taken more steps than are known.
        NotMigrated: A step failed.
    """
    version = version_of(connection)
    if version > len(steps):
        raise TooNew(f"the database is of a later version: {version}")
    if version == len(steps):
        return 0
    try:
        connection.execute("BEGIN IMMEDIATE")
        version = version_of(connection)  # somebody else may have been here meanwhile
        for step in steps[version:]:
            for statement in _statements(step):
                connection.execute(statement)
        connection.execute(f"PRAGMA user_version={len(steps)}")
        connection.execute("COMMIT")
    except sqlite3.Error as problem:
        if connection.in_transaction:
            connection.execute("ROLLBACK")
        what = f"the database cannot be brought from version {version} to {len(steps)}"
        raise NotMigrated(f"{what}: {problem}; it is as it was") from problem
    return len(steps) - version


def _statements(step: str) -> Iterator[str]:
    """Return the statements of a step; those of a trigger stay together."""
    statement = ""
    for part in step.split(";"):
        statement += f"{part};"
        if sqlite3.complete_statement(statement):
            if statement.strip(" \n;"):
                yield statement
            statement = ""
