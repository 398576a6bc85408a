"""Accounts follow the lists: who is new gets one, who is gone stays outside and keeps everything.

An account belongs to a key: the id on a platform, else the e-mail address. So who is called
otherwise keeps it. Who was added in the page stays, whatever the files say, until they name them.
"""

from collections.abc import Iterable, Mapping
from typing import Final, NamedTuple

from vrts.course.people.listed import Listed
from vrts.live.people.naming import Taken, own_name, person_name
from vrts.live.store.accounts import ALL_ROOMS, NOT_CHOSEN, add_account
from vrts.live.store.course.people import Person, all_leading, keep_person, lead, people
from vrts.live.store.database import Connection

SHORTER: Final = 30  # characters of a long name that others have too


class Followed(NamedTuple):
    """What became of people: their accounts."""

    added: tuple[int, ...] = ()
    gone: tuple[int, ...] = ()  # are on no list any more
    changed: tuple[int, ...] = ()  # came back, have another name, or other rights


def follow(
    connection: Connection,
    wanted: Iterable[Listed],
    rooms: Mapping[str, tuple[str, ...]],
    now: float,
    most: int | None = None,
) -> Followed:
    """Give everybody whom the files name an account with their rights.

    Args:
        connection: Of the database.
        wanted: Everybody, each once.
        rooms: Ids of the shared rooms, by name.
        now: Unix time [s].
        most: Accounts that are made; where as many were, others may be left for the next call.
    """
    known = people(connection)
    by_key = {person.key: person for person in known}
    free = {person.account for person in known}
    added: list[int] = []
    changed: list[int] = []
    wanted = tuple(wanted)
    names = _Names(connection)
    keys = {one.key for one in wanted}
    for one in wanted:
        person = by_key.get(one.key) or _by_address(one, known, keys, free)
        if person is None and len(added) == most:
            continue
        if person is None:
            account = _new(connection, names, one, now)
            added.append(account)
        else:
            account = person.account
            if _update(connection, names, person, one, rooms):
                changed.append(account)
        free.discard(account)
        if person is None:
            rights(connection, account, one.rank, one.rooms, rooms)
    gone: list[int] = []
    for person in known:
        if person.account not in free:
            continue
        if person.origin == "page":
            if rights(connection, person.account, person.rank, person.rooms, rooms):
                changed.append(person.account)
        elif person.listed:
            keep_person(connection, person._replace(listed=False))
            rights(connection, person.account, "student", (), rooms)
            gone.append(person.account)
    return Followed(tuple(added), tuple(gone), tuple(changed))


def add_by_hand(
    connection: Connection, one: Listed, rooms: Mapping[str, tuple[str, ...]], now: float
) -> int:
    """Add a teacher or an assistant who stands in no file; return their account.

    Raises:
        ValueError: Somebody of the course has the address.
    """
    for person in people(connection):
        if person.email == one.email or person.key == one.key:
            if person.listed:
                raise ValueError(f"`{person.name}` has this e-mail address already")
            kept = person._replace(
                rank=one.rank, listed=True, origin="page", rooms=one.rooms, key=one.key
            )
            keep_person(connection, kept)
            rights(connection, person.account, one.rank, one.rooms, rooms)
            return person.account
    account = _new(connection, _Names(connection), one, now, origin="page")
    rights(connection, account, one.rank, one.rooms, rooms)
    return account


def end_by_hand(connection: Connection, account: int) -> bool:
    """Let nobody in any more who was added in the page; return whether it was such a person."""
    person = next((one for one in people(connection) if one.account == account), None)
    if person is None or person.origin != "page" or not person.listed:
        return False
    keep_person(connection, person._replace(listed=False, origin="file"))
    rights(connection, account, "student", (), {})
    return True


def rights(
    connection: Connection,
    account: int,
    rank: str,
    named: tuple[str, ...],
    rooms: Mapping[str, tuple[str, ...]],
) -> bool:
    """Give an account the rights of a rank; return whether that changed anything."""
    ids = [id_ for name in named for id_ in rooms.get(name, ())]
    leads = frozenset(ids if named else (ALL_ROOMS,)) if rank == "assistant" else frozenset[str]()
    before = all_leading(connection).get(account, frozenset())
    (supervisor,) = connection.execute(
        "SELECT supervisor FROM account WHERE id=?", (account,)
    ).fetchone()
    teaches = rank == "teacher"
    if before == leads and bool(supervisor) == teaches:
        return False
    connection.execute("UPDATE account SET supervisor=? WHERE id=?", (teaches, account))
    lead(connection, account, sorted(leads))
    return True


def _by_address(one: Listed, known: list[Person], keys: set[str], free: set[int]) -> Person | None:
    """Return whom a list calls otherwise than before: the key was an address, or of elsewhere."""
    if not one.email:
        return None
    for person in known:
        other = person.account in free and person.key not in keys and person.email == one.email
        if other and _platform(person.key) != _platform(one.key):
            return person
    return None


def _platform(key: str) -> str:
    """Return by what a key tells people apart; empty: it is an address, as good as any other."""
    return key.partition(" ")[0] if " " in key else ""


def _new(
    connection: Connection, names: "_Names", one: Listed, now: float, origin: str = "file"
) -> int:
    name = names.new(one)
    account = add_account(connection, name, now, password=NOT_CHOSEN)
    keep_person(
        connection,
        Person(
            account.id,
            account.name,
            one.key,
            one.email,
            one.ids,
            one.rank,
            one.team,
            called=one.name,
            origin=origin,
            rooms=one.rooms,
        ),
    )
    return account.id


def _update(
    connection: Connection,
    names: "_Names",
    person: Person,
    one: Listed,
    rooms: Mapping[str, tuple[str, ...]],
) -> bool:
    """Have somebody be as the list says; return whether others see that."""
    seen = not person.listed
    if one.name != person.called:
        name = names.another(one, person)
        connection.execute("UPDATE account SET name=? WHERE id=?", (name, person.account))
        seen = True
    kept = person._replace(
        key=one.key,
        email=one.email,
        ids=one.ids,
        rank=one.rank,
        team=one.team,
        listed=True,
        called=one.name,
        origin="file",
        rooms=one.rooms,
    )
    if kept != person:
        keep_person(connection, kept)
    return rights(connection, person.account, one.rank, one.rooms, rooms) or seen


class _Names:
    """Gives everybody a name that nobody else has. All names are read but once."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._all: Taken | None = None  # everybody's, once somebody needs it

    def new(self, one: Listed) -> str:
        """Return the name of somebody new."""
        taken = self._all = self._all or self._others(-1)
        name = _free(one, taken)
        taken.add(name)
        return name

    def another(self, one: Listed, person: Person) -> str:
        """Return the name of somebody who is called otherwise than before."""
        self._all = None  # what they were called is free
        return _free(one, self._others(person.account))

    def _others(self, account: int) -> Taken:
        rows = self._connection.execute("SELECT name FROM account WHERE id<>?", (account,))
        return Taken(row[0] for row in rows)


def _free(one: Listed, taken: Taken) -> str:
    student = one.rank == "student"
    name = own_name(person_name(one.name), taken, guest=student)
    if person_name(name) == name:
        return name
    return own_name(person_name(one.name[:SHORTER]), taken, guest=student)  # a number fits behind
