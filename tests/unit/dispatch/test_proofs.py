"""Certificates in bundles: there, about what is sent, and refused when they are not."""

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import msgspec
import pytest
from click.testing import CliRunner, Result

from tests.places import ROOT
from tests.unit.check.proof.test_certificate import formatted
from tests.unit.dispatch.test_bundle import consistent, members, zipped
from vrts.check.proof.certificate import certificate_bytes, read_certificate
from vrts.cli.main import vrts
from vrts.dispatch.bundle import MANIFEST, Bundle, bundle_bytes, read_bundle
from vrts.dispatch.manifest import SCHEMA, WITHOUT_PROOFS, Manifest
from vrts.dispatch.planning.plan import plan
from vrts.dispatch.planning.reasons.refusals import Promise
from vrts.dispatch.planning.wish import Wish
from vrts.dispatch.profile import find_profile
from vrts.dispatch.proofs import check_proofs
from vrts.engine.storage.plain import Json, named
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import load_scene

FIRST_FORMAT = Path(__file__).parents[2] / "data" / "bundles" / "first-format.bundle"
PROOF = "proofs/1.cert"
PROGRAM = """.PROGRAM main()
        MOVE safe
        READY
.END
.LOCATIONS
safe 900.0004 30 100 90 90 0
.END
"""
Change = Callable[[Bundle], Bundle]


def planned(text: str, scene: str = "cans-on-bases") -> Bundle:
    """Return the bundle of a program."""
    request = Request(ProgramFile(text.encode(), "a/b/x.v2"), load_scene(scene), Reading("val2"))
    found = plan(Wish(request, find_profile("mark2-val2")))
    assert found.bundle is not None, found.refused
    return found.bundle


@pytest.fixture(scope="module", name="sound")
def sound_bundle() -> Bundle:
    """Return a bundle with a certificate."""
    return planned(PROGRAM)


@pytest.fixture(scope="module", name="other")
def other_bundle() -> Bundle:
    """Return the bundle of a program that stops elsewhere."""
    return planned(PROGRAM.replace(" 30 ", " 31 "))


NOT_AS_NEAR = (0.5, -0.5, 100.0, None)  # [mm] more than what is proven, or nothing said


def send(home: Path, data: bytes) -> Result:
    """Send a bundle to nobody."""
    path = home / "x.bundle"
    path.write_bytes(data)
    return CliRunner().invoke(vrts, ["dispatch", "send", str(path)])


def manifested(bundle: Bundle, **fields: object) -> Bundle:
    """Return a bundle with another manifest."""
    return replace(bundle, manifest=msgspec.structs.replace(bundle.manifest, **fields))


def rescened(bundle: Bundle, **fields: object) -> Bundle:
    """Return a bundle that says something else of its scenario."""
    (one,) = bundle.manifest.scenarios
    return manifested(bundle, scenarios=(msgspec.structs.replace(one, **fields),))


@pytest.mark.thorough
def test_a_bundle_holds_the_certificate_of_the_text_that_is_sent(
    sound: Bundle, tmp_path: Path
) -> None:
    data = bundle_bytes(sound)
    assert bundle_bytes(planned(PROGRAM)) == data, "the same bytes each time"
    read = read_bundle(data)
    assert read.manifest.schema == SCHEMA
    assert list(read.proofs) == [PROOF]
    assert check_proofs(read) == ()
    said: Json = read_certificate(read.proofs[PROOF]).said["origin"]
    sources = named(named(said)["programs"])["sources"]
    assert sources == [
        ["main.v2", sound.programs["main"]],
        ["locations.lc", sound.locations],
    ]
    assert "900.00 30.00" in sound.locations, "as the controller prints them"
    (one,) = read.manifest.scenarios
    assert one.proof is not None
    assert one.proof.summary.startswith("holds, ")
    assert one.proof.summary in read.sheet
    done = send(tmp_path, data)
    assert done.exit_code == 0, done.output
    assert "certificate" not in done.output


@pytest.mark.thorough
def test_a_bundle_of_an_arm_described_beside_its_scene_depends_on_no_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copytree(ROOT / "scenes" / "one-can-urdf", tmp_path / "cell")
    program = ".PROGRAM main()\n        DRIVE 1, 20, 50\n        READY\n.END\n"
    found: set[bytes] = set()
    for folder, scene in ((tmp_path, "cell"), (tmp_path / "cell", "scene.toml")):
        monkeypatch.chdir(folder)
        found.add(bundle_bytes(planned(program, scene)))
    (data,) = found
    monkeypatch.chdir("/")
    read = read_bundle(data)
    assert list(read.proofs) == [PROOF]
    assert check_proofs(read) == ()


LIFTED = """.PROGRAM main()
        SPEED 20 ALWAYS
        OPENI
        MOVE safe
        APPRO can1_grip, 120
        MOVES can1_grip
        CLOSEI
        APPROS can1_grip, 4
        APPROS can1_grip, 2
        APPROS can1_grip, 200
        APPRO base2_put, 120
        MOVES base2_put
        OPENI
        DEPARTS 120
        MOVE safe
.END
.LOCATIONS
can1_grip  800 -450 -225 90 90 0
base2_put  1100 230 -125 90 90 0
safe       900 30 100 90 90 0
.END
"""


@pytest.mark.thorough
def test_the_distance_told_is_the_one_proven_whatever_was_asked_for() -> None:
    """Lifted by more than that, a can counts when it comes nearer to its base again."""
    told: list[float] = []
    for asked_mm in (1.0, 10.0):
        request = Request(
            ProgramFile(LIFTED.encode(), "x.v2"), load_scene("cans-on-bases"), Reading("val2")
        )
        promises = tuple(Promise(code, "tried", "R. Huber") for code in ("V812", "V813"))
        found = plan(Wish(request, find_profile("mark2-val2"), asked_mm, promises))
        assert found.bundle is not None, found.refused
        assert check_proofs(read_bundle(bundle_bytes(found.bundle))) == ()
        (one,) = found.bundle.manifest.scenarios
        assert one.clearance_mm is not None
        told.append(one.clearance_mm)
    assert told[0] < 3.5 < told[1]


@pytest.mark.thorough
def test_an_altered_certificate_is_refused_and_nothing_is_sent(
    sound: Bundle, tmp_path: Path
) -> None:
    certificate = sound.proofs[PROOF]
    parts = members(bundle_bytes(sound))
    parts[PROOF] = certificate[:-1] + bytes([certificate[-1] ^ 1])
    changed = send(tmp_path, zipped(parts))
    assert changed.exit_code == 1
    assert "V800" in changed.output
    assert "`proofs/1.cert` was changed" in changed.output
    read = read_certificate(certificate)
    assert read.claims.clearance_m is not None
    farther = read.claims._replace(clearance_m=read.claims.clearance_m + 0.01)
    parts[PROOF] = certificate_bytes(read.said, farther, read.evidence)
    forged = send(tmp_path, zipped(consistent(parts)))
    assert forged.exit_code == 1
    assert "V547 certificate-does-not-prove" in forged.output
    parts[PROOF] = b"PK\x03\x04"
    damaged = send(tmp_path, zipped(consistent(parts)))
    assert damaged.exit_code == 1
    assert "V546 damaged-certificate" in damaged.output
    parts[PROOF] = formatted(certificate, 2)
    old = send(tmp_path, zipped(consistent(parts)))
    assert old.exit_code == 1
    assert "V550 certificate-format" in old.output
    assert "was written by an older vrts" in old.output
    assert "help: plan the bundle again with `vrts dispatch plan`" in old.output
    for found in (changed, forged, damaged, old):
        assert "EDIT" not in found.output, "not a line is shown as one to be sent"


def without_certificate(bundle: Bundle) -> Bundle:
    return replace(bundle, proofs={})


def unsaid(bundle: Bundle) -> Bundle:
    return rescened(bundle, proof=None)


def unnamed(bundle: Bundle) -> Bundle:
    (one,) = bundle.manifest.scenarios
    assert one.proof is not None
    return rescened(bundle, proof=msgspec.structs.replace(one.proof, file=None))


def with_another(bundle: Bundle) -> Bundle:
    return replace(bundle, proofs={**bundle.proofs, "proofs/2.cert": b"x"})


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (without_certificate, "the certificate of scenario 1 is missing"),
        (unsaid, "says nothing of the certificate of scenario 1"),
        (unnamed, "no scenario names its certificate `proofs/1.cert`"),
        (with_another, "no scenario names its certificate `proofs/2.cert`"),
    ],
)
def test_a_missing_certificate_is_refused(sound: Bundle, change: Change, words: str) -> None:
    with pytest.raises(Refused) as refused:
        read_bundle(bundle_bytes(change(sound)))
    (found,) = refused.value.diagnostics
    assert found.rule.code == "V800"
    assert words in found.headline


@pytest.mark.thorough
def test_a_certificate_of_another_program_is_refused(
    sound: Bundle, other: Bundle, tmp_path: Path
) -> None:
    found = send(tmp_path, bundle_bytes(replace(sound, proofs=other.proofs)))
    assert found.exit_code == 1
    assert "V549 other-certificate" in found.output
    assert "it is about other programs or data than the bundle" in found.output
    assert "EDIT" not in found.output


def of_scene(manifest: Manifest) -> dict[str, object]:
    return {"scene": msgspec.structs.replace(manifest.scene, sha256="0" * 64)}


def of_model(manifest: Manifest) -> dict[str, object]:
    assert manifest.controller is not None
    return {"controller": msgspec.structs.replace(manifest.controller, sha256="0" * 64)}


def of_no_model(_: Manifest) -> dict[str, object]:
    return {"controller": None}


def of_language(_: Manifest) -> dict[str, object]:
    return {"dialect": "vplus"}


def of_scenario(manifest: Manifest) -> dict[str, object]:
    (one,) = manifest.scenarios
    assert one.proof is not None
    proof = msgspec.structs.replace(one.proof, scenario_sha256="0" * 64)
    return {"scenarios": (msgspec.structs.replace(one, proof=proof),)}


def of_run(manifest: Manifest) -> dict[str, object]:
    (one,) = manifest.scenarios
    return {"scenarios": (msgspec.structs.replace(one, statements=one.statements + 1),)}


def of_distance(by_mm: float | None) -> Callable[[Manifest], dict[str, object]]:
    def change(manifest: Manifest) -> dict[str, object]:
        (one,) = manifest.scenarios
        assert one.clearance_mm is not None
        other = None if by_mm is None else one.clearance_mm + by_mm
        return {"scenarios": (msgspec.structs.replace(one, clearance_mm=other),)}

    return change


@pytest.mark.parametrize(
    ("change", "words"),
    [
        *((of_distance(by_mm), "it proves another smallest distance") for by_mm in NOT_AS_NEAR),
        (of_scene, "it is about another scene"),
        (of_model, "its run goes by another controller model"),
        (of_no_model, "its run goes by another controller model"),
        (of_language, "its program is read in another language"),
        (of_scenario, "it is about another scenario"),
        (of_run, "its run is another than the bundle tells of"),
    ],
)
def test_a_certificate_of_something_else_is_refused(
    sound: Bundle, change: Callable[[Manifest], dict[str, object]], words: str
) -> None:
    with pytest.raises(Refused) as refused:
        check_proofs(manifested(sound, **change(sound.manifest)))
    (found,) = refused.value.diagnostics
    assert found.rule.code == "V549"
    assert words in found.headline


def test_a_bundle_that_says_why_it_has_no_certificate_is_told_of(sound: Bundle) -> None:
    bundle = replace(unnamed(sound), proofs={})
    (note,) = check_proofs(read_bundle(bundle_bytes(bundle)))
    assert "no certificate of its run" in note


def test_a_bundle_of_the_first_format_still_loads_and_says_so(tmp_path: Path) -> None:
    data = FIRST_FORMAT.read_bytes()
    read = read_bundle(data)
    assert read.manifest.schema == WITHOUT_PROOFS
    assert PROOF not in members(data)
    assert b'"proof"' not in members(data)[MANIFEST]
    found = send(tmp_path, data)
    assert found.exit_code == 0, found.output
    assert "note: this bundle is of an older format" in found.output
    assert "EDIT main" in found.output
