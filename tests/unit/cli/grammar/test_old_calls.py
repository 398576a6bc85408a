"""What users of 0.1 type goes on working: its README, and every option of every command."""

import json
import re
import shlex
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from tests.places import ROOT
from tests.support_commands import vrts_text
from tests.unit.cli.grammar.every import every_command, options_of
from vrts import __version__
from vrts.cli.grammar.command import Command
from vrts.cli.grammar.old_names import GONE_WITH, OPTIONS, options_before
from vrts.cli.main import vrts

BEFORE = ROOT / "tests" / "data" / "commands-0.1"
README = BEFORE.joinpath("readme.txt").read_text("utf-8").splitlines()
OPTIONS_BEFORE: dict[str, dict[str, str | list[str]]] = json.loads(
    BEFORE.joinpath("options.json").read_text("utf-8")
)
EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
NEEDS_MORE = {"vrts compile", "vrts run"}  # in prose: no calls
CARRIED_OUT = """\
vrts compile prog.v2
vrts fix prog.v2
vrts fmt prog.v2
vrts support MOVES
vrts support
vrts run prog.v2 --scene cans-on-bases
vrts run prog.v2 --at 4.5
vrts run prog.v2 --from 10 --to 4 --speed -4
vrts run prog.v2 --save out.vrun
vrts verify prog.v2
vrts editor neovim
vrts scene show cans-on-bases
vrts point cans-on-bases 800 200 -250 --down
vrts explain V301
vrts new lab lab.toml
vrts compile prog.v2 --emit store
""".splitlines()


@pytest.mark.parametrize("line", [line for line in README if line not in NEEDS_MORE])
def test_every_command_of_the_readme_is_understood(
    line: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    called: list[click.Context] = []

    def invoke(_: Command, context: click.Context) -> None:
        called.append(context)

    monkeypatch.setattr(Command, "invoke", invoke)
    words = shlex.split(re.sub(r"\|\S+", "", line))[1:]
    monkeypatch.chdir(tmp_path)
    (tmp_path / "out").mkdir()  # what was exported, for `rehearse`
    found = CliRunner().invoke(vrts, words)
    assert (found.exit_code, len(called)) == (0, 1), found.output


@pytest.mark.thorough
def test_commands_of_the_readme_are_carried_out(tmp_path: Path) -> None:
    for file in ("solution.v2", "task.toml"):
        name = "prog.v2" if file == "solution.v2" else file
        (tmp_path / name).write_bytes((EXAMPLE / file).read_bytes())
    for line in CARRIED_OUT:
        assert line in README
        said = vrts_text(*shlex.split(line)[1:], cwd=tmp_path)
        assert said.returncode == 0, (line, said.stderr)
        assert "is now" not in said.stderr


@pytest.mark.parametrize("words", OPTIONS_BEFORE)
def test_every_option_of_before_is_taken(words: str) -> None:
    command = every_command()[words]
    options = options_of(command)
    renamed = {one.old: one.new for one in options_before(words.split()[-1], set(options))}
    for name, before in OPTIONS_BEFORE[words].items():
        option = options[renamed.get(name) or name]
        assert option.is_flag == (before == "flag"), name
        if isinstance(before, list):
            assert isinstance(option.type, click.Choice)
            for value in map(str, before):
                assert option.type.convert(value, option, None) in option.type.choices


OLD_CALLS = [  # each old name once: what is typed, and what is said
    (["run", "prog.v2", "--program", "carry", "--program=main"], "--entry"),
    (["view", "prog.v2", "--with", "browser", "--no-open", "-o", "p.html"], "--viewer"),
    (["view", "prog.v2", "--still", "1", "--out", "p.png"], "--output"),
    (["grade", "intake", "hand-ins", "-o", "t.csv", "--force", "--entry", "main"], "--overwrite"),
    (["scene", "watch", "cans-on-bases", "--for", "0"], "--seconds"),
]


@pytest.mark.thorough
@pytest.mark.parametrize(("words", "now"), OLD_CALLS, ids=[now for _, now in OLD_CALLS])
def test_an_old_name_works_and_is_told_once(words: list[str], now: str, tmp_path: Path) -> None:
    (tmp_path / "prog.v2").write_bytes((EXAMPLE / "solution.v2").read_bytes())
    (tmp_path / "hand-ins").mkdir()
    (tmp_path / "hand-ins" / "anna.v2").write_bytes((EXAMPLE / "solution.v2").read_bytes())
    (tmp_path / "t.csv").write_text("")
    said = vrts_text(*words, cwd=tmp_path)
    assert said.returncode == 0, said.stderr
    assert said.stderr.count("is now") == 1
    assert f"is now `{now}`; the old name works until vrts {GONE_WITH}" in said.stderr
    assert "is now" not in said.stdout
    new = [re.sub(r"^--\w+", now, w) if w.split("=")[0] in _olds(now) else w for w in words]
    again = vrts_text(*new, cwd=tmp_path)
    assert (again.returncode, again.stdout) == (0, said.stdout), again.stderr
    assert "is now" not in again.stderr


def test_an_old_form_is_the_new_one() -> None:
    said = vrts_text("support", "MOVE", "--format", "text")
    assert said.stderr.startswith("note: `text` is now `full`")
    assert said.stdout == vrts_text("support", "MOVE").stdout


def test_old_names_are_not_kept_for_ever() -> None:
    def parts(version: str) -> list[int]:
        return [int(part) for part in version.split(".")]

    assert parts(__version__) < parts(GONE_WITH), "take the old names away"


def _olds(now: str) -> set[str]:
    return {one.old for one in OPTIONS if one.new == now}
