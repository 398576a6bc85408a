"""Signatures of OpenSSH, with real keys: whom they show, and when nobody is shown."""

import shutil
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.places import ROOT
from tests.support_emulator import CARGO, bundle_of, profile
from vrts.cli.main import vrts
from vrts.dispatch.bundle import bundle_bytes
from vrts.dispatch.verifying.signature import NAMESPACE, Signature, Trust, signature_of

pytestmark = pytest.mark.skipif(
    shutil.which("ssh-keygen") is None, reason="signatures need OpenSSH: apt install openssh-client"
)


def key(home: Path, name: str, passphrase: str = "") -> Path:
    """Return a new key."""
    place = home / name
    words = ["ssh-keygen", "-q", "-t", "ed25519", "-N", passphrase, "-C", name, "-f", str(place)]
    subprocess.run(words, check=True, stdin=subprocess.DEVNULL)
    return place


@pytest.fixture(name="home")
def home_with_keys(tmp_path: Path) -> Path:
    """Return a folder with a bundle, two keys, and a file that allows the first."""
    (tmp_path / "x.bundle").write_bytes(bundle_bytes(bundle_of(CARGO, profile())))
    ours = key(tmp_path, "ours")
    key(tmp_path, "theirs")
    public = ours.with_suffix(".pub").read_text()
    (tmp_path / "allowed").write_text(f"huber@lab {public}")
    return tmp_path


def sign(home: Path, name: str) -> Result:
    """Sign the bundle."""
    words = ["dispatch", "sign", str(home / "x.bundle"), "--key", str(home / name)]
    return CliRunner().invoke(vrts, words)


def found(home: Path, signers: str | None = "allowed") -> Signature:
    """Return what the signature shows."""
    data = (home / "x.bundle").read_bytes()
    return signature_of(data, home / "x.bundle.sig", None if signers is None else home / signers)


def test_whose_signature_it_is_only_a_file_of_signers_says(home: Path) -> None:
    assert found(home).trust is Trust.UNSIGNED
    before = (home / "x.bundle").read_bytes()
    done = sign(home, "ours")
    assert done.exit_code == 0, done.output
    assert (home / "x.bundle").read_bytes() == before, "the bundle keeps its bytes"
    assert found(home) == Signature(Trust.TRUSTED, "huber@lab", found(home).key)
    assert found(home).key.startswith("ED25519 key SHA256:")
    assert found(home, None).trust is Trust.VALID
    assert "nothing says whose key" in found(home, None).words


def test_another_key_is_valid_and_not_trusted(home: Path) -> None:
    assert sign(home, "theirs").exit_code == 0
    assert found(home).trust is Trust.FOREIGN


@pytest.mark.parametrize("change", ["bundle", "signature", "nothing left"])
def test_what_was_changed_is_not_signed(home: Path, change: str) -> None:
    sign(home, "ours")
    place = home / ("x.bundle" if change == "bundle" else "x.bundle.sig")
    data = bytearray(place.read_bytes())
    data[len(data) // 2] ^= 3
    place.write_bytes(b"" if change == "nothing left" else bytes(data))
    assert found(home).trust is Trust.WRONG
    assert found(home, None).trust is Trust.WRONG


def test_a_signature_for_another_purpose_is_none(home: Path) -> None:
    words = ["ssh-keygen", "-q", "-Y", "sign", "-f", str(home / "ours")]
    subprocess.run([*words, "-n", "file", str(home / "x.bundle")], check=True)
    assert NAMESPACE != "file"
    assert found(home).trust is Trust.WRONG


def test_a_key_that_is_no_longer_allowed_is_not_trusted(home: Path) -> None:
    sign(home, "ours")
    public = (home / "ours.pub").read_text()
    (home / "allowed").write_text(f'huber@lab valid-before="20200101" {public}')
    assert found(home).trust is Trust.FOREIGN


def test_nothing_is_written_over_and_what_is_no_key_is_told(home: Path) -> None:
    (home / "notes").write_text("no key")
    wrong = sign(home, "notes")
    assert wrong.exit_code == 1
    assert "V844 not-signed" in wrong.output
    assert not (home / "x.bundle.sig").exists()
    missing = sign(home, "nobody")
    assert missing.exit_code == 2
    assert "there is no key" in missing.output
    assert sign(home, "ours").exit_code == 0
    twice = sign(home, "ours")
    assert twice.exit_code == 2
    assert "is there already" in twice.output


def test_nothing_is_sent_that_no_allowed_signer_has_signed(home: Path) -> None:
    words = ["dispatch", "send", str(home / "x.bundle")]
    signers = ["--signers", str(home / "allowed")]
    plain = CliRunner().invoke(vrts, words)
    assert plain.exit_code == 0
    assert "note: it is unsigned: nothing shows who has made it" in plain.output
    refused = CliRunner().invoke(vrts, [*words, *signers])
    assert refused.exit_code == 2
    assert "is not signed by an allowed signer" in refused.output
    sign(home, "ours")
    assert "nobody has looked by whom" in CliRunner().invoke(vrts, words).output
    trusted = CliRunner().invoke(vrts, [*words, *signers])
    assert trusted.exit_code == 0, trusted.output
    assert "note: signed by huber@lab, valid and trusted" in trusted.output


def test_verifying_wants_a_signer_where_signers_are_named(home: Path) -> None:
    shutil.copy(ROOT / "tests" / "data" / "bundles" / "first-format.bundle", home / "x.bundle")
    sign(home, "theirs")
    words = ["dispatch", "verify", str(home / "x.bundle"), "--signers", str(home / "allowed")]
    done = CliRunner().invoke(vrts, words)
    assert done.exit_code == 1
    assert "NO  signature" in done.output
    nobody = CliRunner().invoke(vrts, [*words[:-1], str(home / "nothing")])
    assert nobody.exit_code == 2
    assert "there is no file of allowed signers" in nobody.output
