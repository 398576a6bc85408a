"""`vrts fix` as a user runs it."""

from pathlib import Path

from tests.unit.cli.test_commands import vrts

WRONG = """\
.PROGRAM main
        IF n = 1 THEN
            # open
            OPENI
        ENDIF # done
.END
"""
RIGHT = """\
.PROGRAM main
        IF n == 1 THEN
            ; open
            OPENI
        END ; done
.END
"""


def test_it_lists_what_it_would_do_and_writes_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_text(WRONG)
    result = vrts("fix", path)
    assert result.stdout.decode().splitlines() == [
        f"{path}:2:14: `=` does not compare: write `==` for `=`",
        f"{path}:3:13: `#` begins no comment: write `;` for `#`, and so 1 more place",
        f"{path}:5:9: ENDIF is not a VAL-II instruction: write `END` for `ENDIF`",
    ]
    assert result.returncode == 0
    assert path.read_text() == WRONG


def test_diff_shows_and_write_writes(tmp_path: Path) -> None:
    path, link = tmp_path / "a.v2", tmp_path / "link.v2"
    path.write_text(WRONG)
    path.chmod(0o640)
    link.symlink_to(path)
    result = vrts("fix", "--diff", path)
    assert b"-        IF n = 1 THEN\n" in result.stdout
    assert b"+        IF n == 1 THEN\n" in result.stdout
    assert path.read_text() == WRONG
    result = vrts("fix", "--write", link)
    assert (result.returncode, result.stdout) == (0, b"")
    assert result.stderr.decode().startswith(f"mended {link}, a link to {path}: ")
    assert link.is_symlink()
    assert path.read_text() == RIGHT
    assert path.stat().st_mode & 0o777 == 0o640
    assert vrts("fix", path).stderr == f"{path}: nothing to mend\n".encode()


def test_from_stdin() -> None:
    result = vrts("fix", "--write", "-", stdin=WRONG.encode())
    assert (result.returncode, result.stdout.decode()) == (0, RIGHT)


def test_what_is_left_is_said() -> None:
    result = vrts("fix", "-", stdin=b".PROGRAM main\n        MOVE\n.END\n")
    assert result.returncode == 1
    assert result.stderr.decode().splitlines() == [
        "stdin: nothing to mend for certain",
        "stdin: 1 error is left; `vrts compile -` says more",
    ]


def test_what_is_no_text_is_not_touched(tmp_path: Path) -> None:
    path = tmp_path / "a.v2"
    path.write_bytes(b"%PDF-1.7\n")
    result = vrts("fix", "--write", path)
    assert result.returncode == 1
    assert b"V102" in result.stderr
    assert path.read_bytes() == b"%PDF-1.7\n"
