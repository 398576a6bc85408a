"""`vrts fmt`, and the options that say how programs are read, as a user runs them."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.unit.cli.test_commands import HEAVY, SOLUTION, vrts

UGLY = ".program main\nmove P ; go\n.end\n"
NEAT = ".PROGRAM main\n        MOVE p  ; go\n.END\n"


def test_fmt_rewrites_a_file_and_keeps_its_mode(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_text(UGLY)
    path.chmod(0o640)
    result = vrts("fmt", path)
    assert (result.returncode, result.stderr) == (0, f"changed {path}\n".encode())
    assert path.read_text() == NEAT
    assert path.stat().st_mode & 0o777 == 0o640
    before = path.stat().st_mtime_ns
    assert vrts("fmt", path).stderr == b""
    assert path.stat().st_mtime_ns == before  # not written again


def test_fmt_check_and_diff_write_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_text(UGLY)
    result = vrts("fmt", "--check", path)
    assert (result.returncode, result.stderr) == (1, f"would change {path}\n".encode())
    result = vrts("fmt", "--diff", path)
    assert result.returncode == 0
    assert b"-move P ; go\n" in result.stdout
    assert b"+        MOVE p  ; go\n" in result.stdout
    assert path.read_text() == UGLY
    path.write_text(NEAT)
    assert vrts("fmt", "--check", path).returncode == 0


def test_fmt_from_stdin() -> None:
    result = vrts("fmt", "-", stdin=UGLY.encode())
    assert (result.returncode, result.stdout.decode()) == (0, NEAT)


def test_fmt_does_not_touch_what_is_no_text(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_bytes(b"%PDF-1.7\n")
    result = vrts("fmt", path)
    assert result.returncode == 1
    assert b"V102" in result.stderr
    assert path.read_bytes() == b"%PDF-1.7\n"


def test_fmt_keeps_an_8_bit_code_page(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_bytes(".program a\nmove p ; Stra\xdfe\n.end\n".encode("cp1252"))
    assert vrts("fmt", path).returncode == 0
    assert path.read_bytes() == ".PROGRAM a\n        MOVE p ; Stra\xdfe\n.END\n".encode(
        "cp1252"
    ).replace(b"p ; ", b"p  ; ")


def test_fmt_writes_what_a_link_leads_to(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    real, link = tmp_path / "real" / "a.v2", tmp_path / "link.v2"
    real.write_text(UGLY)
    real.chmod(0o604)
    link.symlink_to(Path("real") / "a.v2")
    (tmp_path / "real" / "a.v2.part").write_text("mine")
    result = vrts("fmt", link)
    assert result.returncode == 0
    assert result.stderr.decode() == f"changed {link}, a link to {real}\n"
    assert link.is_symlink()
    assert real.read_text() == NEAT
    assert real.stat().st_mode & 0o777 == 0o604
    assert sorted(path.name for path in real.parent.iterdir()) == ["a.v2", "a.v2.part"]
    assert (tmp_path / "real" / "a.v2.part").read_text() == "mine"


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files away")
def test_fmt_keeps_the_owner(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_text(UGLY)
    os.chown(path, 1234, 4321)
    assert vrts("fmt", path).returncode == 0
    assert (path.stat().st_uid, path.stat().st_gid) == (1234, 4321)
    assert path.read_text() == NEAT


def test_fmt_gives_a_pipe_the_bytes_that_a_file_would_get() -> None:
    data = b"\xef\xbb\xbf" + UGLY.replace("go", "Stra\xdfe").replace("\n", "\r\n").encode()
    result = vrts("fmt", "-", stdin=data)
    assert result.stdout.startswith(b"\xef\xbb\xbf.PROGRAM main\r\n        MOVE p  ; Stra\xc3\x9f")
    assert result.stdout.count(b"\r\n") == 3


def test_fmt_says_which_lines_nobody_reads(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_text("garbage")
    for call, stdin in ((path, b""), ("-", b"garbage")):
        result = vrts("fmt", call, stdin=stdin)
        assert result.returncode == 1
        assert b"line 1 cannot be read and stays as it is; `vrts compile " in result.stderr
    assert result.stdout == b"garbage"
    assert path.read_text() == "garbage"


def test_files_compile_together(tmp_path: Path) -> None:
    main, points = tmp_path / "main.v2", tmp_path / "points.lc"
    main.write_text(".PROGRAM main\n        CALL go(spot)\n.END\n")
    points.write_text(
        ".PROGRAM go(l)\n        MOVE l\n.END\n.LOCATIONS\nspot 1 2 3 90 90 x\n.END\n"
    )
    alone = vrts("compile", main)
    assert b"there is no program `go`" in alone.stderr
    both = vrts("compile", main, "--with", points)
    assert both.returncode == 1
    assert f"{points}:5:1".encode() in both.stderr  # told where it stands
    points.write_text(points.read_text().replace("90 x", "90 0"))
    both = vrts("compile", main, "--with", points)
    assert (both.returncode, both.stderr.decode()) == (
        0,
        f"{main}: 2 programs, 1 value, compiles\n",
    )


def test_replace_takes_the_last_program(tmp_path: Path) -> None:
    first, second = tmp_path / "a.v2", tmp_path / "b.v2"
    first.write_text('.PROGRAM main\n        TYPE "old"\n.END\n')
    second.write_text('.PROGRAM main\n        TYPE "new"\n.END\n')
    assert vrts("run", first, "--with", second).returncode == 1
    assert vrts("run", first, "--with", second, "--replace").stdout == b"new\n"


def test_dialect_and_precedence(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_text(".PROGRAM main\n        TYPE /I0, 1 OR 0 == 1\n        EXECUTE 2 main\n.END\n")
    assert vrts("compile", path).returncode == 1
    assert vrts("compile", path, "--dialect", "val2+").returncode == 0
    path.write_text(".PROGRAM main\n        TYPE /I0, 1 OR 0 == 1\n.END\n")
    assert vrts("run", path).stdout == b"0\n"
    assert vrts("run", path, "--prec", "B").stdout == b"-1\n"


def test_store_is_read_back_byte_for_byte(tmp_path: Path) -> None:
    stored = tmp_path / "stored.v2"
    stored.write_bytes(vrts("compile", SOLUTION, "--emit", "store").stdout)
    assert vrts("compile", stored, "--emit", "store").stdout == stored.read_bytes()
    assert vrts("compile", stored, "--emit", "store", "--exact").returncode == 0


def test_output_of_a_program_cannot_steer_the_terminal(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_text(
        '.PROGRAM main\n        TYPE $CHR(27)+"[31mred", /B\n        TYPE "::error::x"\n.END\n'
    )
    shown = vrts("run", path).stdout
    assert b"\x1b" not in shown
    assert b"\x07" not in shown
    assert not any(line.startswith(b"::") for line in shown.splitlines())


@pytest.mark.parametrize("command", ["fmt", "support", "compile"])
def test_language_commands_load_nothing_heavy(command: str) -> None:
    script = (
        "import sys; from vrts.cli.main import vrts; "
        f"vrts(['{command}', '--help'], standalone_mode=False); "
        f"print(sorted(set({HEAVY!r}) & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "[]"
