"""`vrts dispatch send`, `fetch`, `diff` and `emulate` as a user calls them: real processes."""

import subprocess
import sys
from collections.abc import Generator
from pathlib import Path

import pytest

from tests.support_commands import vrts_text
from tests.support_emulator import CARGO, PICK, bundle_of
from vrts.cli.dispatch.serial_line import dated
from vrts.dispatch.bundle import bundle_bytes
from vrts.dispatch.profile import find_profile
from vrts.dispatch.steps import Steps
from vrts.dispatch.transfer.cargo import Cargo

if sys.platform == "win32":
    pytest.skip("Windows has no pseudo-terminals", allow_module_level=True)

PATIENCE = 60.0  # [s] with a busy machine
KNOWN = find_profile("mark2-val2")


def vrts(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return vrts_text("dispatch", *arguments, cwd=folder)


def write(folder: Path, cargo: Cargo = CARGO) -> str:
    path = folder / "pick.bundle"
    path.write_bytes(bundle_bytes(bundle_of(cargo, KNOWN)))
    return path.name


@pytest.fixture(name="port")
def emulated(tmp_path: Path) -> Generator[str]:
    """Return the port of an emulated controller, a process of its own."""
    command = [sys.executable, "-m", "vrts.cli.main", "dispatch", "emulate", "--baud", "115200"]
    with subprocess.Popen(
        command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as process:
        assert process.stdout is not None
        yield process.stdout.readline().strip()
        process.terminate()


def test_what_is_wrong_with_a_file_is_told_to_whoever_wants_few_words(tmp_path: Path) -> None:
    (tmp_path / "bad.v2").write_text(".PROGRAM bad()\nMOVVE here\n.END\n")
    words = [sys.executable, "-m", "vrts.cli.main", "dispatch", "emulate", "bad.v2", "-q"]
    with subprocess.Popen(
        words, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline().strip()  # the port: all files are loaded
        process.terminate()
        _, said = process.communicate(timeout=PATIENCE)
    assert "MOVVE" in said


def test_a_dry_run_prints_what_would_be_typed_and_opens_nothing(tmp_path: Path) -> None:
    found = vrts(tmp_path, "send", write(tmp_path), "--port", str(tmp_path / "none"))
    assert found.returncode == 0
    assert "dry run: nothing was sent" in found.stderr
    rows = found.stdout.splitlines()
    assert rows[:4] == [
        "     command  STATUS",
        "     command  LISTP pick",
        "     command  LISTP put",
        "     command  LISTL",
    ]
    start = rows.index("     command  EDIT pick")
    assert rows[start : start + 7] == [
        "     command  EDIT pick",
        "      step 1  ; fetch one part",
        "      step 2  SPEED 30 ALWAYS",
        "      step 3  I",
        "    insert 3  d = 5",
        "    insert 4  ''",
        "      step 4  I",
    ]
    assert list(tmp_path.iterdir()) == [tmp_path / "pick.bundle"]


@pytest.mark.thorough
def test_a_bundle_goes_there_and_back(tmp_path: Path, port: str) -> None:
    bundle = write(tmp_path)
    differs = vrts(tmp_path, "diff", bundle, "--port", port)
    assert differs.returncode == 1
    assert "-.PROGRAM pick  (not on the controller)" in differs.stdout
    sent = vrts(tmp_path, "send", bundle, "--port", port, "--really")
    assert sent.returncode == 0, sent.stderr
    assert "note: the profile `mark2-val2` was not tried on hardware" in sent.stderr
    assert sent.stdout == (
        "program pick: verified\nprogram put: verified\n"
        "location part: verified\nlocation tray[2]: verified\nlocation #safe: verified\n"
    )
    assert "transcript: pick.bundle." in sent.stderr
    assert vrts(tmp_path, "diff", bundle, "--port", port).returncode == 0
    fetched = vrts(
        tmp_path, "fetch", "PUT", "--port", port, "--profile", "mark2-val2", "-o", "back.v2"
    )
    assert fetched.returncode == 0, fetched.stderr
    assert (tmp_path / "back.v2").read_text().startswith(".PROGRAM put(n, at)\n        MOVE at:")
    again = vrts(tmp_path, "fetch", "--port", port, "--profile", "mark2-val2", "-o", "back.v2")
    assert again.returncode == 2
    assert "`back.v2` is there already" in again.stderr
    logs = [path.read_text() for path in tmp_path.glob("*.log")]
    assert len(logs) == 4
    assert sum(" > EDIT pick\n" in log for log in logs) == 1


def test_what_is_replaced_is_kept_beside_the_bundle(tmp_path: Path, port: str) -> None:
    bundle = write(tmp_path, Cargo((Steps("pick", "", ("READY",)),), (), (("count", "5"),)))
    first = vrts(tmp_path, "send", bundle, "--port", port, "--really")
    assert first.returncode == 1  # a number is missing
    assert "to be entered by hand at the controller: count = 5" in first.stderr
    other = write(tmp_path, Cargo((PICK,), (), ()))
    refused = vrts(tmp_path, "send", other, "--port", port, "--really")
    assert refused.returncode == 1
    assert "error[V838 there-already]" in refused.stderr
    assert refused.stdout == "program pick: another program (1 step)\n"
    replaced = vrts(tmp_path, "send", other, "--port", port, "--really", "--replace")
    assert replaced.returncode == 0, replaced.stderr
    (copy,) = tmp_path.glob("pick.bundle.*.before.v2")
    assert copy.read_text() == ".PROGRAM pick\n        READY\n.END\n"


def test_what_may_not_be_sent_is_refused_before_anything_is(tmp_path: Path) -> None:
    place = CARGO.places[0]._replace(values=("1E5", *CARGO.places[0].values[1:]))
    bundle = write(tmp_path, Cargo(CARGO.programs, (place,), ()))
    found = vrts(tmp_path, "send", bundle, "--really", "--port", "/dev/none")
    assert found.returncode == 1
    assert "error[V842 not-sent]: '1E5,200.00," in found.stderr


def test_a_profile_can_be_copied_and_corrected(tmp_path: Path) -> None:
    listed = vrts(tmp_path, "profile").stdout.splitlines()
    assert listed[1] == "mark2-val2      Unimation Mark II with VAL-II, not tried on hardware"
    text = vrts(tmp_path, "profile", "mark2-val2").stdout
    (tmp_path / "mine.toml").write_text(text.replace("baud = 9600", "baud = 4800"))
    sent = vrts(tmp_path, "send", write(tmp_path), "--profile", "mine.toml")
    assert sent.returncode == 0
    assert "note: the profile is not, to the letter," in sent.stderr


def test_a_wrong_call_is_told_in_a_sentence(tmp_path: Path) -> None:
    bundle = write(tmp_path)
    assert vrts(tmp_path, "send", bundle, "--really").returncode == 2
    none = vrts(tmp_path, "send", bundle, "--really", "--port", "/dev/none")
    assert none.returncode == 1
    assert "error[V832 no-port]: the port `/dev/none` cannot be opened" in none.stderr
    assert "the system says: no such file or directory" in none.stderr
    other = vrts(tmp_path, "send", bundle, "--profile", "kawasaki-as")
    assert "error[V843 other-profile]" in other.stderr
    unknown = vrts(tmp_path, "send", bundle, "--profile", "mark9")
    assert unknown.returncode == 2
    assert "profiles: kawasaki-as, mark2-val2" in unknown.stderr
    assert vrts(tmp_path, "send", "none.bundle").returncode == 2


def test_what_does_not_fit_the_controller_is_told_before_anything_is_sent(tmp_path: Path) -> None:
    long = Steps("pick", "", ("; " + "x" * 100,))
    found = vrts(tmp_path, "send", write(tmp_path, Cargo((long,), (), ())))
    assert found.returncode == 1
    assert "step 1 of `pick` has 102 characters, a line at most 80" in found.stderr
    place = CARGO.places[0]._replace(values=("1.2345", *CARGO.places[0].values[1:]))
    found = vrts(tmp_path, "send", write(tmp_path, Cargo(CARGO.programs, (place,), ())))
    assert "`part` has more decimals than the 2 that are listed" in found.stderr


def test_calls_in_one_second_have_transcripts_of_their_own(tmp_path: Path) -> None:
    names: set[str] = set()
    for _ in range(3):
        name = dated(tmp_path / "pick.bundle").name
        (tmp_path / f"{name}.log").touch()
        names.add(name)
    assert len(names) == 3


def test_two_replacements_in_one_second_keep_two_copies(tmp_path: Path) -> None:
    names: set[str] = set()
    for _ in range(3):  # their transcripts may lie elsewhere: `--transcript`
        name = dated(tmp_path / "pick.bundle").name
        (tmp_path / f"{name}.before.v2").touch()
        names.add(name)
    assert len(names) == 3
