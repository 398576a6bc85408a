"""What a course keeps of a person: handed out whole, and forgotten, and nothing of anybody else."""

import io
import zipfile
from contextlib import closing
from pathlib import Path

import msgspec
import pytest

from vrts.course.handing.deposit import HandIn, begin, done, place
from vrts.course.handing.names import folder_of
from vrts.course.personal.forgetting import forget
from vrts.course.personal.handing_out import hand_out
from vrts.live.settings import DATABASE
from vrts.live.store.accounts import add_account
from vrts.live.store.course.attempts import add_attempt, all_attempts
from vrts.live.store.course.people import Person, keep_person, people
from vrts.live.store.database import Connection, opened

ADA, BO = "Ada Lind", "Bo Berg"
STAMP = "2026-11-01-10-00-00"


class Class:
    """A course in which two have handed in, once each alone and once together."""

    def __init__(self, folder: Path) -> None:
        self.course, self.server = folder / "course", folder / "kept"
        self.server.mkdir()
        self.accounts: dict[str, int] = {}
        with closing(opened(self.server / DATABASE)) as connection:
            for name in (ADA, BO):
                email = f"{name.split()[0].lower()}@example.org"
                account = add_account(connection, name, 0.0, password="x").id
                keep_person(connection, Person(account, name, email, email, {}, "student"))
                self.accounts[name] = account
            self.hand_in(connection, b"alone A", ADA)
            self.hand_in(connection, b"alone B", BO)
            self.hand_in(connection, b"together", ADA, BO)
        for name in (ADA, BO):
            own = self.course / "published" / "pick" / "a1b2" / self.folder(name)
            own.mkdir(parents=True)
            (own / "final.json").write_text(name)

    def folder(self, name: str) -> str:
        return folder_of(email := f"{name.split()[0].lower()}@example.org", email)

    def hand_in(self, connection: Connection, program: bytes, *names: str) -> None:
        whole = self.whole(program, *names)
        done(begin(self.course / "handed-in", whole))
        place(self.course / "handed-in", whole)
        report = self.server / "handing" / "pages" / "pick" / f"{whole.digest}.html"
        report.parent.mkdir(parents=True, exist_ok=True)
        report.write_bytes(program)
        for account, _ in whole.people:
            add_attempt(connection, account, "pick", 1.0, whole.by, whole.digest)

    def whole(self, program: bytes, *names: str) -> HandIn:
        stamp = STAMP[:-2] + f"{len(program):02d}"
        mine = tuple((self.accounts[name], self.folder(name)) for name in names)
        return HandIn("pick", 1, stamp, mine[0][0], mine, "", program)

    def names(self) -> list[str]:
        """Return the files of course and server that hand-ins and publications are."""
        homes = (self.course / "handed-in", self.course / "published", self.server / "handing")
        found = (path for home in homes for path in home.rglob("*") if path.is_file())
        return sorted(path.read_bytes().decode() for path in found)


@pytest.fixture
def class_(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Class:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))  # the key of the logs
    return Class(tmp_path)


def test_everything_of_a_person_is_handed_out_and_nothing_of_others(class_: Class) -> None:
    target = io.BytesIO()
    told = hand_out(class_.course, class_.server, ADA, target)
    with zipfile.ZipFile(target) as archive:
        names = [name for name in archive.namelist() if name.startswith("course/")]
        texts = {archive.read(name) for name in names}
    assert told.files == 4  # two programs, what was published, a report of hers alone
    assert {b"alone A", b"together", ADA.encode()} <= texts
    assert b"alone B" not in texts
    assert BO.encode() not in texts
    assert "person.json" in zipfile.ZipFile(target).namelist()


def test_somebody_unknown_is_nobody(class_: Class) -> None:
    assert hand_out(class_.course, class_.server, "Cy", io.BytesIO()).server.accounts == 0
    before = class_.names()
    assert forget(class_.course, class_.server, "Cy").files == 0
    assert class_.names() == before


def test_a_purge_forgets_a_person_and_leaves_the_team_its_work(class_: Class) -> None:
    waiting = begin(class_.course / "handed-in", class_.whole(b"waits", ADA, BO))
    told = forget(class_.course, class_.server, ADA)
    assert told.listed
    assert told.server.accounts == 1
    assert not list(class_.course.rglob(class_.folder(ADA)))
    left = msgspec.json.decode(waiting.read_bytes(), type=HandIn)
    assert [account for account, _ in left.people] == [class_.accounts[BO]]
    assert left.by == class_.accounts[BO]
    waiting.unlink()
    assert class_.names() == [BO, "alone B", "alone B", "together", "together"]
    with closing(opened(class_.server / DATABASE)) as connection:
        assert [one.name for one in people(connection)] == [BO]
        assert {one.account for one in all_attempts(connection)} == {class_.accounts[BO]}
        together = [one for one in all_attempts(connection) if one.by == class_.accounts[ADA]]
    assert together == []  # who handed in for the team is forgotten there too
