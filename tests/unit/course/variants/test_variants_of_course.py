"""A task that is another one for each student, in a course: their words, robot and mark."""

import shutil
import stat
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.places import ROOT
from tests.support_handing import PASSWORD, enrol, log_in, work
from tests.support_live import Json, LiveServer
from vrts.assignments.variants.key import NAME, key_of, place_of_handed, place_of_key
from vrts.assignments.variants.of_task import load_varied
from vrts.cli.main import vrts
from vrts.course.handing.child import Reader
from vrts.course.handing.spoken import TellIt, Words
from vrts.course.variants.asked import Called, GiveIt, Given
from vrts.course.variants.giving import CHANGED, NO_KEY, Giver
from vrts.marking.layout import Layout
from vrts.marking.row import class_from_bytes
from vrts.marking.variants.handed import read_handed, variant_of

LAB = ROOT / "examples" / "08-own-numbers" / "lab1"
COURSE = """\
[course]
title = "Robotics"
roster = "roster.csv"

[[assignment]]
task = "tasks/lab1"
"""
PEOPLE = (("Cy Dahl", "cy@example.org", ""), ("Di Ek", "di@example.org", ""))
ROSTER = "name,email\n" + "".join(f"{name},{email}\n" for name, email, _ in PEOPLE)


def course_folder(folder: Path, more: str = "") -> Path:
    shutil.copytree(LAB, folder / "tasks" / "lab1")
    (folder / "roster.csv").write_text(ROSTER)
    (folder / "course.toml").write_text(COURSE + more)
    return folder


def asked(course: Path, *emails: str, team: str = "") -> GiveIt:
    """Return the question for somebody's variant."""
    task, roster = course / "tasks" / "lab1" / "task.toml", course / "roster.csv"
    people = tuple(Called(email, {}) for email in emails)
    return GiveIt(str(task), str(roster), people, team, str(course.parent / "variants"))


def record(course: Path) -> dict[str, str]:
    """Return the tags that stand in the sealed record, by whose they are."""
    task = course / "tasks" / "lab1"
    key = place_of_key(task)
    found = read_handed(key, key_of(key), "own-numbers")
    return {name: one.tag for name, one in found.items()}


@pytest.fixture(scope="module")
def giver() -> Giver:
    return Giver()


def test_a_variant_is_given_once_sealed_and_another_for_each(tmp_path: Path, giver: Giver) -> None:
    course = course_folder(tmp_path / "course")
    (tmp_path / "variants").mkdir()
    cy = giver.give(asked(course, "cy@example.org"))
    di = giver.give(asked(course, "di@example.org"))
    assert cy.problem == di.problem == ""
    assert cy.tag != di.tag
    assert record(course) == {"sis cy@example.org": cy.tag, "sis di@example.org": di.tag}
    assert giver.give(asked(course, "cy@example.org")) == cy, "and it stays"
    task = course / "tasks" / "lab1"
    for path in (place_of_key(task), place_of_handed(place_of_key(task))):
        assert stat.S_IMODE(path.stat().st_mode) == 0o600
    files = {path.name for path in Path(cy.task).parent.rglob("*") if path.is_file()}
    assert {"task.toml", "scene.toml", "README.md", "start.v2"} <= files
    assert "solution.v2" not in files
    texts = "".join(p.read_text() for p in Path(cy.task).parent.rglob("*") if p.is_file())
    assert "[variants]" not in texts, "nothing tells what others may have"
    assert di.tag not in texts
    shown = Reader().answer(TellIt(cy.task))
    assert isinstance(shown, Words)
    assert f"variant `{cy.tag}`" in shown.readme
    assert shown.start.startswith(f"; variant {cy.tag}")


def test_a_team_has_one_variant_and_each_member_keeps_it(tmp_path: Path, giver: Giver) -> None:
    course = course_folder(tmp_path / "course")
    (tmp_path / "variants").mkdir()
    alone = giver.give(asked(course, "cy@example.org"))
    team = giver.give(asked(course, "di@example.org", "cy@example.org", team="Red"))
    assert team.tag != alone.tag
    same = dict.fromkeys(("team Red", "sis cy@example.org", "sis di@example.org"), team.tag)
    assert record(course) == same, "so marking marks each by the team's"
    assert giver.give(asked(course, "cy@example.org")).tag == team.tag, "who has left keeps it"


def test_what_was_handed_out_is_never_drawn_again(tmp_path: Path, giver: Giver) -> None:
    course = course_folder(tmp_path / "course")
    (tmp_path / "variants").mkdir()
    given = giver.give(asked(course, "cy@example.org"))
    task, key = course / "tasks" / "lab1" / "task.toml", course / "tasks" / "lab1" / NAME
    text = task.read_text()
    moved = text.replace("from = 720", "from = 725", 1).replace("to = 840", "to = 845", 1)
    task.write_text(moved)  # whatever was drawn, no place of before is among those
    assert giver.give(asked(course, "cy@example.org")) == Given(problem=CHANGED)
    task.write_text(text)
    assert giver.give(asked(course, "cy@example.org")).tag == given.tag
    sealed = place_of_handed(key)
    kept = sealed.read_bytes()
    sealed.write_bytes(kept.replace(given.tag.encode(), b"bbbb-bbbb"))
    assert giver.give(asked(course, "cy@example.org")).problem == NO_KEY, "it was changed"
    sealed.unlink()
    assert giver.give(asked(course, "cy@example.org")).problem == NO_KEY, "it is gone"
    sealed.write_bytes(kept)
    assert giver.give(asked(course, "cy@example.org")).tag == given.tag


def hand_in(server: LiveServer, cookie: str, text: str, number: int) -> None:
    body = {"assignment": "lab1", "text": text, "attempt": number, "late": ""}
    answer = server.request("POST", "/course/work/hand-in", body, cookie=cookie)
    assert answer.status == 200, answer.body


def marked(server: LiveServer, cookie: str) -> Json:
    """Return the latest attempt once it is marked; each look waits for the server's answer."""
    for _ in range(20_000):
        latest = work(server, cookie)["attempts"][0]
        if latest["state"] != "waiting":
            return latest
    raise AssertionError("it was never marked")


def scene_of_robot(server: LiveServer, cookie: str) -> str:
    """Open one's own robot for the assignment; return what its browser draws."""
    answer = server.request("POST", "/course/robots", {"scene": "lab1"}, cookie=cookie)
    assert answer.status == 200, answer.body
    room = answer.json["room"]
    browser = server.join(cookie, room=room)
    snapshot = browser.wait("snapshot")
    while snapshot["state"] is None:
        snapshot = {**snapshot, **browser.wait("state")}
    number = next(m["session"] for m in reversed(browser.came) if m.get("session"))
    return server.request("GET", f"/scene/{room}/{number}", cookie=cookie).body.decode()


@pytest.mark.thorough
def test_each_student_sees_does_and_is_marked_by_their_own_variant(tmp_path: Path) -> None:
    course = course_folder(tmp_path / "course", "[robots]\neach = 2\n")
    enrol(tmp_path / "live", PEOPLE, PASSWORD)
    with LiveServer(tmp_path / "live", scenes=(str(course),)) as server:
        cy, di = (log_in(server, name) for name, _, _ in PEOPLE)
        words = [
            server.request("GET", "/course/work/text/lab1", cookie=who).body.decode()
            for who in (cy, di)
        ]
        tags = [record(course)[f"sis {email}"] for _, email, _ in PEOPLE]
        for own, other, text in zip(tags, reversed(tags), words, strict=True):
            assert own in text
            assert other not in text
        key = course / "tasks" / "lab1" / NAME
        varied = load_varied(key.parent).with_key(key_of(key))
        handed = read_handed(key, key_of(key), "own-numbers")
        solutions: list[str] = []
        for tag, (_, email, _) in zip(tags, PEOPLE, strict=True):
            own = variant_of(varied.variants, handed[f"sis {email}"])
            assert own is not None
            program = (varied.reference(own.combination) or b"").decode()
            solutions.append(f"; variant {tag}\n{program}")
        scenes = [scene_of_robot(server, who) for who in (cy, di)]
        assert scenes[0] != scenes[1], "each robot stands in a scene of its own"
        hand_in(server, cy, solutions[0], 1)
        hand_in(server, di, solutions[0], 1)  # the same program, for somebody else's numbers
        own, copy = marked(server, cy), marked(server, di)
        assert (own["mark"], own.get("said", "")) == ("10.0", "")
        assert float(copy["mark"]) <= 5
        told = f"It names the variant `{tags[0]}`, and yours is `{tags[1]}`: it is marked by yours"
        assert copy["said"].endswith(told[1:])
        page = server.request("GET", "/course/work/page/lab1/1", cookie=di)
        assert page.status == 200
    out = tmp_path / "marked"
    told = CliRunner().invoke(vrts, ["course", "mark", str(course), "lab1", "-o", str(out)])
    assert told.exit_code in (0, 1), told.output
    rows = {
        row.student.email: row for row in class_from_bytes(Layout(out).results.read_bytes()).rows
    }
    given = [rows[email].result.variant for _, email, _ in PEOPLE]
    assert [one.tag for one in given if one is not None] == tags
    assert rows["cy@example.org"].final == 10.0
    (doubt,) = [one.sentence for one in rows["di@example.org"].unsafe]
    assert f"`{tags[0]}`, of `Cy Dahl`" in doubt
