"""Who has signed a bundle: a detached signature of OpenSSH, made and checked by `ssh-keygen`.

The signature lies beside the bundle, `NAME.sig`, so that the bundle keeps its bytes. That it is
valid shows only that somebody has the key. Whose key that is, and whether to trust it, says a file
of allowed signers (`man ssh-keygen`, ALLOWED SIGNERS), and nothing else does.
"""

import shutil
import subprocess
from enum import Enum
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Rule, error
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.report.plain import one_line

NOT_SIGNED = Rule("V844", "not-signed")

NAMESPACE = "vrts-bundle"  # what is signed for one purpose is not valid for another
SUFFIX = ".sig"
MOST_BYTES = 100_000  # of a signature
LONGEST_S = 60.0  # that `ssh-keygen` may take where nobody types a passphrase
_PROGRAM = "ssh-keygen"


class Trust(Enum):
    """What a signature is worth."""

    UNSIGNED = "unsigned"
    WRONG = "wrong"  # not of these bytes, or no signature
    VALID = "valid"  # of some key; nobody was asked whose
    FOREIGN = "foreign"  # valid, of a key that no allowed signer has
    TRUSTED = "trusted"  # of the key of somebody who may sign


class Signature(NamedTuple):
    """What is known of who has signed."""

    trust: Trust
    who: str = ""  # as the file of allowed signers names them
    key: str = ""  # "ED25519 key SHA256:..."

    @property
    def words(self) -> str:
        """One line for people."""
        match self.trust:
            case Trust.UNSIGNED:
                return "unsigned: nothing shows who has made it"
            case Trust.WRONG:
                return "the signature is not one of this bundle"
            case Trust.VALID:
                return f"signed with {self.key}, valid; nothing says whose key that is"
            case Trust.FOREIGN:
                return f"signed with {self.key}, valid; it is the key of no allowed signer"
            case Trust.TRUSTED:
                return f"signed by {self.who}, valid and trusted ({self.key})"


def beside(bundle: Path) -> Path:
    """Return where the signature of a bundle lies."""
    return bundle.with_name(bundle.name + SUFFIX)


def signed(data: bytes, key: Path) -> bytes:
    """Return the signature of a bundle; `ssh-keygen` asks for a passphrase at the terminal.

    Args:
        data: The file of the bundle.
        key: A private key, or a public one whose private key an agent holds.

    Raises:
        CannotRead: There is no `ssh-keygen`, or no such key.
        Refused: It does not sign.
    """
    if not key.is_file():
        raise CannotRead(f"there is no key `{key}`", ("make one: `ssh-keygen -t ed25519`",))
    done = _keygen(["sign", "-n", NAMESPACE, "-f", str(key.resolve())], data, None)
    if done.returncode != 0:
        headline = f"`{key}` does not sign: {_said(done.stderr)}"
        help_ = ("name a private key of OpenSSH that you may use",)
        raise Refused((error(NOT_SIGNED, headline, help=help_),))
    return done.stdout


def signature_of(data: bytes, signature: Path, signers: Path | None) -> Signature:
    """Return what a signature shows.

    Args:
        data: The file of the bundle.
        signature: File of its signature; it may be missing.
        signers: File of allowed signers; None: nobody is trusted.

    Raises:
        CannotRead: There is no `ssh-keygen`, or no such file of signers.
    """
    if signers is not None and not signers.is_file():
        raise CannotRead(f"there is no file of allowed signers `{signers}`")
    if not signature.is_file():
        return Signature(Trust.UNSIGNED)
    if signature.stat().st_size > MOST_BYTES:
        return Signature(Trust.WRONG)
    held = ["-n", NAMESPACE, "-s", str(signature.resolve())]
    valid = _keygen(["check-novalidate", *held], data)
    if valid.returncode != 0:
        return Signature(Trust.WRONG)
    key = _said(valid.stdout).partition(" with ")[2] or "a key"
    if signers is None:
        return Signature(Trust.VALID, key=key)
    allowed = ["-f", str(signers.resolve())]
    found = _keygen(["find-principals", "-s", str(signature.resolve()), *allowed], b"")
    for who in found.stdout.decode("utf-8", "replace").splitlines():
        done = _keygen(["verify", *held, *allowed, "-I", who], data)
        if done.returncode == 0:
            return Signature(Trust.TRUSTED, one_line(who)[:200], key)
    return Signature(Trust.FOREIGN, key=key)


def _keygen(
    arguments: list[str], data: bytes, longest_s: float | None = LONGEST_S
) -> "subprocess.CompletedProcess[bytes]":
    program = shutil.which(_PROGRAM)
    if program is None:
        raise CannotRead(
            "signatures are made and checked by OpenSSH, and there is no `ssh-keygen` here",
            ("install it: on Debian and Ubuntu `sudo apt install openssh-client`",),
        )
    command = [program, "-Y", *arguments]
    try:
        return subprocess.run(  # noqa: S603 -- our own command
            command, input=data, capture_output=True, check=False, timeout=longest_s
        )
    except subprocess.TimeoutExpired as problem:
        raise CannotRead(f"`{_PROGRAM}` has not answered within {longest_s:g} s") from problem


def _said(text: bytes) -> str:
    lines = text.decode("utf-8", "replace").strip().splitlines()
    return one_line(lines[-1])[:200] if lines else "it says nothing"
