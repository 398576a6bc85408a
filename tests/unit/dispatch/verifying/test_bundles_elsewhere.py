"""A bundle is proven again elsewhere, from nothing but its file; what was changed is told."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import msgspec
import pytest
from click.testing import CliRunner, Result

from tests.places import ROOT
from tests.unit.dispatch.test_bundle import consistent, members, zipped
from tests.unit.dispatch.test_proofs import FIRST_FORMAT
from vrts.cli.main import vrts
from vrts.dispatch.bundle import MANIFEST, bundle_bytes, read_bundle

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
PROGRAM = """.PROGRAM main()
        READY
        CALL above
        IF SIG(1001) THEN
          MOVE safe
        END
.END
.LOCATIONS
safe 900.0004 30 100 90 90 0
.END
"""
OTHER = ".PROGRAM above()\n        MOVE safe:TRANS(0, 0, -50, 90, -90, 0)\n.END\n"
SCENARIO = 'title = "the part comes"\n[[inputs]]\nsignal = 1001\non_s = [0.5]\n'
ENVIRONMENT = 'title = "the part stays"\n[[inputs]]\nsignal = 1001\nis = "held"\nstate = "either"\n'
TASK = """[task]
scene = "cans-on-bases"
[time]
reference_s = 20
[[rule]]
must_use = "CALL"
points = 0.5
"""


def command(*words: str | Path) -> Result:
    """Type a command of `vrts dispatch`."""
    return CliRunner().invoke(vrts, ["dispatch", *map(str, words)])


@pytest.fixture(scope="module", name="bundle")
def planned_bundle(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """Return a bundle that took everything there is: task, scenarios, another file, a profile."""
    home = tmp_path_factory.mktemp("plan")
    (home / "lab1").mkdir()
    (home / "lab1" / "main.v2").write_text(PROGRAM)
    (home / "above.v2").write_text(OTHER)
    (home / "part.toml").write_text(SCENARIO)
    (home / "held.toml").write_text(ENVIRONMENT)
    (home / "task.toml").write_text(TASK)
    profile = CliRunner().invoke(vrts, ["dispatch", "profile", "mark2-val2"])
    (home / "our-val2.toml").write_text(profile.stdout.replace('"mark2-val2"', '"our-val2"'))
    done = command(
        *("plan", home / "lab1" / "main.v2", "--with", home / "above.v2"),
        *("--task", home / "task.toml", "--scenario", home / "part.toml"),
        *("--environment", home / "held.toml"),
        *("--profile", home / "our-val2.toml", "-o", home / "x.bundle", "--clearance", "8"),
    )
    assert done.exit_code == 0, done.output
    return (home / "x.bundle").read_bytes()


def verified(home: Path, data: bytes, *more: str | Path) -> Result:
    """Verify the bytes of a bundle."""
    (home / "x.bundle").write_bytes(data)
    return command("verify", home / "x.bundle", *more)


@pytest.mark.thorough
def test_everything_is_proven_again_from_the_file_alone(
    bundle: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = verified(tmp_path, bundle, "--sheet", tmp_path / "sheet.html")
    assert done.exit_code == 0, done.output
    assert "planned again: the same to the last byte; 2 programs, 1 scenario" in done.output
    assert "--  signature    unsigned: nothing shows who has made it" in done.output
    assert "Proven again by vrts" in (tmp_path / "sheet.html").read_text()
    asked = read_bundle(bundle).manifest.asked
    assert asked is not None
    assert (asked.program, asked.others, asked.scenarios) == (
        "main.v2",
        ("above.v2",),
        ("part.toml",),
    )
    assert b"plan0" not in bundle.replace(b"\0", b""), "no folder is named"


@pytest.mark.thorough
def test_what_is_known_is_told_to_programs_too(bundle: bytes, tmp_path: Path) -> None:
    done = verified(tmp_path, bundle, "--format", "json")
    said = json.loads(done.stdout)
    assert said["holds"] is True
    assert said["planned_again"] == {"same_bytes": True, "refused": [], "differences": []}
    assert said["signature"]["trust"] == "unsigned"


def again(data: bytes, **fields: object) -> bytes:
    """Return a bundle with another manifest, as a forger would write it."""
    read = read_bundle(data)
    return bundle_bytes(replace(read, manifest=msgspec.structs.replace(read.manifest, **fields)))


def forged(name: str, old: bytes, new: bytes) -> Callable[[bytes], bytes]:
    """Return what changes a file of a bundle, and says so in its manifest."""

    def change(data: bytes) -> bytes:
        parts = members(data)
        assert old in parts[name], parts[name]
        return zipped(consistent({**parts, name: parts[name].replace(old, new)}))

    return change


FORGERIES: tuple[tuple[Callable[[bytes], bytes], str], ...] = (
    (forged("given/program", b"READY", b"READY\n  READY"), "program `main` is another"),
    (forged("given/other-1", b"-50", b"-60"), "program `above` is another"),
    (forged("given/program", b"900.0004", b"910"), "the locations are others"),
    (forged("given/task", b"= 20", b"= 30"), "`task` of the manifest is another"),
    (
        forged("given/environment", b"part stays", b"part stood"),
        "`futures` of the manifest is another",
    ),
    (forged("given/profile", b"= 80", b"= 78"), "`profile_sha256` of the manifest is another"),
    (lambda data: zipped(members(data)), "its files are packed in another way"),
    (lambda data: again(data, clearance_asked_mm=7.0), "`proofs/1.cert` is another"),
    (lambda data: again(data, margins=()), "`margins` of the manifest is another"),
)


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("change", "says"),
    [
        (forged("given/scenario-1", b"0.5", b"0.7"), "`scenarios` of the manifest is another"),
        (forged("sheet.html", b"Operator", b"operator"), "`sheet.html` is another"),
        *(pytest.param(*case, marks=pytest.mark.thorough) for case in FORGERIES),
    ],
)
def test_what_was_changed_is_told(
    bundle: bytes, change: Callable[[bytes], bytes], says: str, tmp_path: Path
) -> None:
    done = verified(tmp_path, change(bundle), "--sheet", tmp_path / "sheet.html")
    assert done.exit_code == 1, done.output
    assert f"NO  planned      planned again, {says}" in done.output, done.output
    assert done.output.endswith("not verified\n")
    assert not (tmp_path / "sheet.html").exists()


@pytest.mark.thorough
def test_a_bundle_that_would_be_refused_now_says_why(bundle: bytes, tmp_path: Path) -> None:
    lower = forged("given/program", b"900.0004 30 100", b"900 30 -400")(bundle)
    done = verified(tmp_path, lower)
    assert done.exit_code == 1
    assert "NO  planned      planned again, it is refused for" in done.output
    assert "error[V8" in done.output


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("given/program", "`given/program` is missing"),
        ("given/scene", "`given/scene` is missing"),
        ("given/profile", "`given/profile` is missing"),
    ],
)
def test_a_file_that_is_missing_is_named(
    bundle: bytes, name: str, says: str, tmp_path: Path
) -> None:
    parts = members(bundle)
    del parts[name]
    done = verified(tmp_path, zipped(consistent(parts)))
    assert done.exit_code == 1
    assert says in done.output


def test_a_bundle_of_the_first_format_is_named_unsigned_and_cannot_be_proven_again(
    tmp_path: Path,
) -> None:
    done = verified(tmp_path, FIRST_FORMAT.read_bytes())
    assert done.exit_code == 1
    assert "of an older format, which does not hold what it was planned from" in done.output
    assert "unsigned" in done.output


def test_a_format_says_what_it_was_planned_from_or_is_old(bundle: bytes, tmp_path: Path) -> None:
    for fields in ({"asked": None}, {"schema": "vrts.bundle/3"}):
        parts = members(again(bundle, **fields))
        assert json.loads(parts[MANIFEST])["files"]
        done = verified(tmp_path, zipped(parts))
        assert done.exit_code == 1
        assert "it does not say what it was planned from" in done.output


@pytest.mark.thorough
@pytest.mark.parametrize(
    "number",
    ["01-cans-on-bases", "02-dish-on-stand", "03-around-obstacles", "04-final-project"],
)
def test_the_examples_are_proven_again_elsewhere(
    number: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    solution = ROOT / "examples" / number / "solution.v2"
    done = command("plan", solution, "--profile", "mark2-val2", "-o", tmp_path / "x.bundle")
    assert done.exit_code == 0, done.output
    monkeypatch.chdir(tmp_path)
    assert command("verify", "x.bundle").exit_code == 0
