"""What the manual says about a server for a term is so: its commands, numbers and unit."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.golden.limit_table import HEAD, limit_table
from tests.golden.server_page import PAGE, fits, follow
from tests.support_commands import vrts_text
from tests.unit.live.store.test_migrations import contents, tables_of
from vrts.live.entrance import guessing, log_ins
from vrts.live.front import program_pages
from vrts.live.limits import PLACES
from vrts.live.logs import replay_page
from vrts.live.settings import DATABASE
from vrts.live.store.database import opened
from vrts.live.tokens import LETTERS
from vrts.live.watching.health import DYING, UNWRITTEN
from vrts.live.watching.service import PLACE, STATE, USER

TEXT = PAGE.read_text("utf-8")
WORDS = " ".join(TEXT.split())
VRTS = Path(sys.executable).with_name("vrts")
SERVICE = re.compile(r"^\$ vrts (serve .* --service)$", re.M)


@pytest.mark.thorough
def test_every_command_of_the_page_answers_as_shown(tmp_path: Path) -> None:
    steps = list(follow(TEXT, tmp_path))
    assert len(steps) > 12
    for step in steps:
        assert fits(step), (
            f"{PAGE.name}:{step.line}: $ {step.command}\n"
            f"--- shown\n{step.shown}\n--- real\n{step.real}\n"
            "(python -m tests.golden.server_page writes the real output)"
        )


def test_the_limits_of_the_page_are_those_of_the_code() -> None:
    shown = re.search(rf"^{re.escape(HEAD)}(?:\|.*\n)+", TEXT, re.M)
    assert shown is not None
    assert shown[0] == limit_table(), "python -m tests.golden.server_page writes them anew"
    assert f"| {PLACES} |" in shown[0]


def test_the_page_says_who_gets_in_by_the_numbers_of_the_code() -> None:
    length, letters = guessing.SHORTEST, len(LETTERS)
    many, power = f"{guessing.codes(length):.1e}".split("e+")
    chance, less = f"{float(guessing.chance()) + 0.05e-7:.1e}".split("e-0")
    for words in (
        f"A class code has {length} characters of an alphabet of {letters}",
        f"{many} × 10{''.join('⁰¹²³⁴⁵⁶⁷⁸⁹'[int(d)] for d in power)} codes",
        f"a probability below {chance} × 10⁻{'⁰¹²³⁴⁵⁶⁷⁸⁹'[int(less)]}",
        f"After {guessing.BUDGET // 1_000_000} million of them",
        f"Each longer code allows {guessing.GROWTH} times the guesses",
        f"doubles from one second to {'a minute' if log_ins.LONGEST_S == 60.0 else '?'}",
        {5: "five wrong ones are free"}.get(log_ins.FREE, "?"),
        f"`{UNWRITTEN}`",
        f"`{DYING}`",
        f"`{PLACE}`",
        f"XDG_STATE_HOME=/var/lib/{STATE}",
        f"su -s /bin/bash {USER}",
    ):
        assert words in WORDS, words


def test_the_line_for_cron_makes_a_backup(tmp_path: Path) -> None:
    (line,) = re.findall(r"^[\d ]+\* \* \* vrts (\S+ .*)$", TEXT, re.M)
    opened(tmp_path / DATABASE).close()
    (tmp_path / "copies").mkdir()
    command = line.replace(r"\%", "%").replace("/opt/vrts/.venv/bin/vrts", f"{VRTS}")
    command = command.replace("/srv/vrts", f"{tmp_path}").replace(
        "/var/backups/vrts", f"{tmp_path}/copies"
    )
    done = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    (copy,) = (tmp_path / "copies").iterdir()
    assert contents(copy, tables_of(copy)) == contents(tmp_path / DATABASE, tables_of(copy))


def test_nginx_lets_through_what_the_server_takes() -> None:
    (size,) = re.findall(r"client_max_body_size (\d+)m;", TEXT)
    assert int(size) * 1_000_000 > program_pages.LONGEST_BODY
    (time_s,) = re.findall(r"proxy_read_timeout (\d+)s;", TEXT)
    assert int(time_s) > replay_page.LONGEST_S


@pytest.mark.skipif(shutil.which("systemd-analyze") is None, reason="needs systemd-analyze")
def test_systemd_takes_the_unit_of_the_page(tmp_path: Path) -> None:
    command = SERVICE.search(TEXT)
    assert command is not None
    file = tmp_path / Path(PLACE).name
    file.write_text(vrts_text(*command[1].split()).stdout)
    words = ["systemd-analyze", "verify", "--man=no", str(file)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr + done.stdout


@pytest.mark.skipif(shutil.which("caddy") is None, reason="needs caddy")
def test_caddy_takes_the_lines_of_the_page(tmp_path: Path) -> None:
    (shown,) = re.findall(r"```text\n(lab\.example\.org \{\n.*?)```", TEXT, re.S)
    file = tmp_path / "Caddyfile"
    file.write_text(shown)
    words = ["caddy", "adapt", "--adapter", "caddyfile", "--config", str(file)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert '"dial":"127.0.0.1:8000"' in done.stdout
