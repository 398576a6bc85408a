"""Ctrl-C where it is the usual end of a command: nothing is wrong then, and nothing is said."""

import signal
import subprocess
import sys
from pathlib import Path

import pytest

VRTS = str(Path(sys.prefix) / "bin" / "vrts")


@pytest.mark.parametrize(
    ("words", "ready"),
    [
        (("scene", "watch", "cans-on-bases"), "can1"),
        (("serve", "cans-on-bases", "--port", "0"), "only this machine can reach it"),
    ],
    ids=["scene watch", "serve"],
)
def test_it_ends_without_a_word(words: tuple[str, ...], ready: str, tmp_path: Path) -> None:
    with subprocess.Popen(
        [VRTS, *words],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as process:
        assert process.stdout is not None
        while ready not in process.stdout.readline():
            assert process.poll() is None, "it ended by itself"
        process.send_signal(signal.SIGINT)
        rest, _ = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "interrupted" not in rest
    assert "Aborted" not in rest
