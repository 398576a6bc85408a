"""The built site: no fault, nothing from elsewhere, found by its search, man pages beside it."""

import re
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_site import built_site
from tests.unit.cli.test_commands import vrts
from vrts.cli.language import manual_command
from vrts.site import placing
from vrts.site.made_of import (
    FIRST,
    MAN,
    NOTE,
    TOOLS,
    faults_of,
    is_made_of,
    made_of,
    note_down,
)
from vrts.site.placing import put_in_place

LOADED = re.compile(r'<(?:script|img|link|iframe|source)\b[^>]*?(?:src|href)="([^"]+)"')
SET_OFF = re.compile(r"<(table|pre)\b.*?</\1>", re.S)
FROM_STYLE = re.compile(r"url\(\s*['\"]?([^'\")]+)|@import\s+['\"]([^'\"]+)")


def pages() -> list[Path]:
    return sorted(built_site().rglob("*.html"))


def test_sphinx_has_nothing_against_the_pages() -> None:
    assert faults_of(built_site()) == ""


def test_no_page_loads_anything_from_elsewhere() -> None:
    site = built_site()
    assert len(pages()) > 80
    for page in pages():
        for target in LOADED.findall(page.read_text("utf-8")):
            assert ":" not in target, (page.name, target)
            assert not target.startswith("//"), (page.name, target)
            assert (page.parent / target.split("?")[0].split("#")[0]).exists(), (page.name, target)
    for style in site.rglob("*.css"):
        for names in FROM_STYLE.findall(style.read_text("utf-8")):
            target = "".join(names)
            assert target.startswith("data:") or ":" not in target, (style.name, target)


def test_a_bar_is_escaped_in_no_page() -> None:
    """Where code is written by hand it stays as it is: in Emacs Lisp `\\|` means or."""
    for page in pages():
        shown = SET_OFF.sub("", page.read_text("utf-8"))
        assert "\\|" not in shown, page.name
    page = built_site() / "look-up" / "commands" / "compile.html"
    assert '<span class="pre">[full|concise|json|' in page.read_text("utf-8")
    man = (built_site() / "man" / "vrts-compile.1").read_text("utf-8")
    assert "[full|concise|json|" in man


def test_the_pages_hold_no_date_and_no_folder_of_this_machine() -> None:
    for page in pages():
        words = page.read_text("utf-8")
        assert str(ROOT) not in words
        assert "/tmp/tmp" not in words
        assert "Last updated" not in words


def test_the_search_knows_words_and_recipes() -> None:
    index = (built_site() / "searchindex.js").read_text("utf-8")
    titles = index.partition('"alltitles"')[2] or index.partition("alltitles")[2]
    for title in ("MOVES", "SIGNAL", "V301 out-of-reach", "Cans on bases", "vrts verify"):
        assert f'"{title}"' in titles, title


def test_a_site_is_built_anew_when_something_in_it_changes(tmp_path: Path) -> None:
    root = tmp_path / "checkout"
    (root / "vrts" / "manual").mkdir(parents=True)
    page = root / "vrts" / "manual" / "index.md"
    page.write_text("# One\n")
    before = made_of(root)
    assert before == made_of(root)
    (root / "vrts" / "__pycache__").mkdir()
    (root / "vrts" / "__pycache__" / "x.py").write_text("")
    assert made_of(root) == before
    page.write_text("# Two\n")
    assert made_of(root) != before
    changed = made_of(root)
    (root / "vrts" / "__init__.pyi").write_text("def run() -> None: ...\n")
    assert made_of(root) != changed
    assert not is_made_of(tmp_path, before)
    assert is_made_of(built_site(), made_of(ROOT))


def test_a_site_is_built_anew_with_another_version_of_what_it_is_built_with() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    wanted = {re.split(r"[<>=]", one)[0] for one in project["build-system"]["requires"]}
    assert wanted - {"hatchling"} <= set(TOOLS)


def a_site(folder: Path, words: str) -> Path:
    (folder / MAN).mkdir(parents=True)
    (folder / FIRST).write_text(words)
    (folder / MAN / "vrts.1").write_text(words)
    note_down(folder, "digest", "")
    return folder


@pytest.mark.parametrize("left_out", [FIRST, MAN, NOTE])
def test_a_site_that_is_not_whole_is_built_anew(left_out: str, tmp_path: Path) -> None:
    site = a_site(tmp_path / "built", "new")
    assert is_made_of(site, "digest")
    (site / left_out).rename(tmp_path / "elsewhere")
    assert not is_made_of(site, "digest")


def test_an_interrupted_copy_leaves_the_site_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    new, place = a_site(tmp_path / "new", "new"), a_site(tmp_path / "room" / "built", "old")

    def interrupted(source: Path, target: Path) -> None:
        assert (place / FIRST).read_text() == "old"
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(placing.shutil, "copy", interrupted)
        with pytest.raises(KeyboardInterrupt):
            put_in_place(new, place)
    assert [path.name for path in place.parent.iterdir()] == ["built"]
    assert (place / FIRST).read_text() == "old"

    put_in_place(new, place)
    assert [path.name for path in place.parent.iterdir()] == ["built"]
    assert (place / FIRST).read_text() == (place / MAN / "vrts.1").read_text() == "new"
    assert is_made_of(place, "digest")
    put_in_place(new, tmp_path / "first")
    assert is_made_of(tmp_path / "first", "digest")


@pytest.mark.skipif(shutil.which("man") is None, reason="there is no man")
def test_man_shows_a_command() -> None:
    page = built_site() / "man" / "vrts-verify.1"
    shown = subprocess.run(
        ["man", "--warnings", "-E", "UTF-8", "-l", page], capture_output=True, text=True, check=True
    )
    assert shown.stderr == ""
    assert "vrts verify [OPTIONS]" in shown.stdout


def test_there_is_a_man_page_of_everything_and_of_each_command() -> None:
    man = built_site() / "man"
    names = {path.name for path in man.iterdir()}
    assert {"vrts.1", "vrts-verify.1", "vrts-grade.1", "vrts-manual.1"} <= names
    whole = (man / "vrts.1").read_text("utf-8")
    assert "vrts scene check" in whole


# --- the command ----------------------------------------------------------------------------------


def test_the_command_prints_where_the_manual_is() -> None:
    first = built_site() / "index.html"
    assert vrts("manual", "--path").stdout.decode().strip() == str(first)


def test_the_command_says_what_to_do_where_it_was_not_built(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(manual_command, "SITE", tmp_path)
    with pytest.raises(SystemExit) as ended:
        manual_command.command.main(["--path"], standalone_mode=False)
    assert ended.value.code == 1
    said = capsys.readouterr().err
    assert "were not built" in said
    assert "pip install -e ." in said


def test_the_browser_is_given_the_page_as_a_file(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    built_site()
    opened: list[str] = []

    def note(page: str) -> bool:
        opened.append(page)
        return True

    monkeypatch.setattr(manual_command.webbrowser, "open", note)
    manual_command.command.main([], standalone_mode=False)
    assert opened == [(built_site() / "index.html").as_uri()]
    assert capsys.readouterr().out.strip().endswith("index.html")
