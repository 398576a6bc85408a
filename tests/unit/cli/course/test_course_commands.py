"""`vrts course`: files to begin with, faults, people and personal links."""

import csv
import io
import sqlite3
import stat
from pathlib import Path

import pytest

from tests.support_commands import vrts_text
from tests.support_course import course_folder
from vrts.live.settings import DATABASE

ADDRESS = ("--address", "https://lab.example.org/")


def links(text: str) -> dict[str, str]:
    rows = csv.DictReader(io.StringIO(text))
    return {row["name"]: row["link"] for row in rows}


def test_links_are_made_once_and_anew_only_where_asked(tmp_path: Path) -> None:
    course, live = course_folder(tmp_path / "course"), ("--folder", str(tmp_path / "live"))
    table = tmp_path / "letters.csv"
    said = vrts_text("course", "letters", course, *live, *ADDRESS, "-o", table)
    assert (said.returncode, said.stderr) == (0, "4 links\n")
    assert stat.S_IMODE(table.stat().st_mode) == 0o600
    first = links(table.read_text())
    assert set(first) == {"Ada Lind", "Bo Berg", "Cy Dahl", "Di Ek"}
    start = "https://lab.example.org/course/first#"
    assert all(link.startswith(start) for link in first.values())
    kept = (tmp_path / "live" / DATABASE).read_bytes()
    assert not any(link.removeprefix(start).encode() in kept for link in first.values())
    again = vrts_text("course", "letters", course, *live, *ADDRESS, "-o", "-")
    assert links(again.stdout) == {}
    anew = ("--again", "cy@example.org", "-o", "-")
    only = links(vrts_text("course", "letters", course, *live, *ADDRESS, *anew).stdout)
    assert set(only) == {"Cy Dahl"}
    assert only["Cy Dahl"] != first["Cy Dahl"]
    nobody = ("--again", "Nobody", "-o", "-")
    said = vrts_text("course", "letters", course, *live, *ADDRESS, *nobody)
    assert (said.returncode, "is called `Nobody`" in said.stderr) == (2, True)
    listed = vrts_text("course", "people", course, *live).stdout
    assert listed.count("never") == 4
    assert "Lab" in listed


def test_a_table_that_cannot_be_written_leaves_no_link_behind(tmp_path: Path) -> None:
    course, live = course_folder(tmp_path / "course"), tmp_path / "live"
    words = ("course", "letters", course, "--folder", live, *ADDRESS, "-o")
    assert vrts_text(*words, tmp_path / "nowhere" / "letters.csv").returncode != 0
    connection = sqlite3.connect(live / DATABASE)
    assert connection.execute("SELECT count(*) FROM letter").fetchone() == (0,)
    connection.close()
    assert len(links(vrts_text(*words, "-").stdout)) == 4


def test_all_faults_are_shown_at_once(tmp_path: Path) -> None:
    course = course_folder(tmp_path / "course")
    (course / "roster.csv").write_text("name,email\n,x@example.org\nCy,\nDi,di@example.org\n")
    said = vrts_text("course", "check", course)
    assert said.returncode == 1
    assert "this line has no name" in said.stderr
    assert "`Cy` has neither e-mail address nor id" in said.stderr
    assert "V914" in said.stderr
    more = '\n[login]\nissuer = "http://id.example.org"\nclient = "x"\nsecret = "secret"\n'
    said = vrts_text("course", "check", course_folder(course, more=more))
    assert said.returncode == 1
    assert "only on this machine itself" in said.stderr
    assert "it lies in the folder of the course" in said.stderr
    said = vrts_text("course", "check", tmp_path)
    assert (said.returncode, "course.toml" in said.stderr) == (2, True)


@pytest.mark.thorough
def test_who_is_still_listed_is_not_forgotten_unless_that_is_meant(tmp_path: Path) -> None:
    course, live = course_folder(tmp_path / "course"), ("--folder", str(tmp_path / "live"))
    assert vrts_text("course", "letters", course, *live, *ADDRESS, "-o", "-").returncode == 0
    purge = ("course", "purge", course, "Cy Dahl", *live, "--log-key", tmp_path / "key")
    said = vrts_text(*purge)
    assert said.returncode == 1
    assert "roster.csv:2, and would get a new account: nothing was forgotten" in said.stderr
    assert "take the line out" in said.stderr
    assert "Cy Dahl" in vrts_text("course", "people", course, *live).stdout
    meant = vrts_text(*purge, "--still-listed")
    assert (meant.returncode, "accounts forgotten: 1" in meant.stderr) == (0, True)
    assert "roster.csv:2 gives them a new, empty account" in meant.stderr
    assert vrts_text("course", "letters", course, *live, *ADDRESS, "-o", "-").returncode == 0
    roster = course / "roster.csv"
    lines = roster.read_text().splitlines(keepends=True)
    roster.write_text("".join(line for line in lines if "Cy Dahl" not in line))
    said = vrts_text(*purge)
    assert (said.returncode, "accounts forgotten: 1" in said.stderr) == (0, True)
    assert "new account" not in said.stderr
    assert vrts_text("course", "letters", course, *live, *ADDRESS, "-o", "-").returncode == 0
    assert "Cy Dahl" not in vrts_text("course", "people", course, *live).stdout
    assert "nothing is kept of `Cy Dahl`" in vrts_text(*purge).stderr
