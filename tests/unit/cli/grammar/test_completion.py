"""Tab in real shells: what is offered for files, scenes, codes, words and students."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support_commands import vrts_text

BIN = Path(sys.prefix) / "bin"
BASH = """\
PATH="$0:$PATH"
eval "$(vrts completion bash)"
compopt() { :; }  # there is no line that is being typed
for line in "$@"; do
  COMP_WORDS=($line)
  [[ $line == *" " ]] && COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _vrts_completion vrts
  echo "${COMPREPLY[*]}"
done
"""


@pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")
def test_bash(tmp_path: Path) -> None:
    (tmp_path / "out" / "students" / "anna").mkdir(parents=True)
    lines = ["vrts ver", "vrts explain V40", "vrts verify p.v2 --scene cans", "vrts support MOVE"]
    lines += ["vrts grade evidence --from out a", "vrts grade evid", "vrts verify --jso"]
    said = subprocess.run(
        ["bash", "-c", BASH, BIN, *lines],
        capture_output=True,
        text=True,
        check=True,
        cwd=tmp_path,
    )
    assert said.stderr == ""
    commands, codes, scenes, words, students, below, options = said.stdout.splitlines()
    assert commands == "verify"
    assert "V400" in codes.split()
    assert scenes == "cans-on-bases"
    assert {"MOVE", "MOVES"} <= set(words.split())
    assert (students, below, options) == ("anna", "evidence", "--json")


@pytest.mark.thorough
@pytest.mark.skipif(shutil.which("fish") is None, reason="needs fish")
def test_fish(tmp_path: Path) -> None:
    script = (
        f"set -x PATH {BIN} $PATH; vrts completion fish | source;"
        ' complete -C "vrts explain V40"; complete -C "vrts scene show cans"'
    )
    said = subprocess.run(
        ["fish", "-c", script], capture_output=True, text=True, check=True, cwd=tmp_path
    )
    assert {"V400", "cans-on-bases"} <= {line.split("\t")[0] for line in said.stdout.splitlines()}


@pytest.mark.thorough
@pytest.mark.skipif(shutil.which("zsh") is None, reason="needs zsh")
def test_zsh(tmp_path: Path) -> None:
    script = """\
path=($1 $path)
autoload -U compinit; compinit -D
eval "$(vrts completion zsh)"
_describe() { print -l -- ${(P)4} ${(P)3} }
compadd() { print -l -- $completions }
words=(vrts explain V40); CURRENT=3
_vrts_completion
print -- ${_comps[vrts]}
"""
    said = subprocess.run(
        ["zsh", "-f", "-c", script, "zsh", BIN],
        capture_output=True,
        text=True,
        check=True,
        cwd=tmp_path,
    )
    assert "V400" in said.stdout.split()
    assert said.stdout.split()[-1] == "_vrts_completion"


def test_files_are_left_to_the_shell() -> None:
    said = vrts_text(
        env={
            **os.environ,
            "_VRTS_COMPLETE": "bash_complete",
            "COMP_WORDS": "vrts run pr",
            "COMP_CWORD": "2",
        }
    )
    assert said.stdout == "file,pr\n"
