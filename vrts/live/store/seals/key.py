"""The key that signs the logs of a user's servers: a file outside of the folders that it guards."""

import hmac
import os
import secrets
from pathlib import Path
from typing import Final

import msgspec

from vrts.pipeline.files import CannotRead

NAME: Final = "log-key"
SIZE: Final = 32  # bytes
_OTHERS: Final = 0o077  # modes that let somebody else read or write

Field = str | int | float | bool | bytes


def usual_key() -> Path:
    """Return where the key is if nobody says otherwise: where programs keep their own state."""
    base = os.environ.get("XDG_STATE_HOME", "")
    if not Path(base).is_absolute():
        try:
            base = str(Path.home() / ".local" / "state")
        except RuntimeError as problem:
            raise CannotRead(
                "vrts cannot find your home folder, so it has no place for a key",
                ("say where it is to be: `--log-key FILE`",),
            ) from problem
    return Path(base) / "vrts" / NAME


class LogKey:
    """A key that was read."""

    def __init__(self, path: Path, secret: bytes) -> None:
        """Take what the file holds."""
        self.path = path
        self._secret = secret
        self.id = self.sign("key", b"")[:8]  # tells keys apart, and nothing about them

    def sign(self, kind: str, database: bytes, *fields: Field) -> bytes:
        """Return the sign of some fields of one kind, in one database."""
        plain = [field.hex() if isinstance(field, bytes) else field for field in fields]
        said = msgspec.json.encode((kind, database.hex(), *plain))
        return hmac.digest(self._secret, said, "sha256")

    def signed(self, seal: object, kind: str, database: bytes, *fields: Field) -> bool:
        """Return whether something is the sign of some fields."""
        if not isinstance(seal, bytes):
            return False
        return hmac.compare_digest(seal, self.sign(kind, database, *fields))


def require_outside(path: Path, folder: Path) -> None:
    """See to it that a key does not lie in the folder that it guards.

    Raises:
        CannotRead: It does.
    """
    if path.resolve().is_relative_to(folder.resolve()):
        raise CannotRead(
            f"the key `{path}` is in the folder of the database",
            ("keep it elsewhere: who can change the database must not have it",),
        )


def read_key(path: Path) -> LogKey | None:
    """Return the key in a file; None: there is no such file.

    Raises:
        CannotRead: It holds no key, or somebody else could have read it.
    """
    try:
        with path.open("rb") as file:
            mode = os.fstat(file.fileno()).st_mode
            data = file.read(4 * SIZE)
    except FileNotFoundError:
        return None
    except OSError as problem:
        raise CannotRead(f"cannot read the key `{path}`: {problem.strerror}") from problem
    if os.name == "posix" and mode & _OTHERS:
        raise CannotRead(
            f"others may read the key `{path}`",
            (f"only you should: `chmod 600 {path}`",),
        )
    try:
        secret = bytes.fromhex(data.decode("ascii"))
    except ValueError:  # what is no ASCII, too
        secret = b""
    if len(secret) != SIZE:
        raise CannotRead(f"there is no key in `{path}`: it has {2 * SIZE} hexadecimal digits")
    return LogKey(path, secret)


def make_key(path: Path) -> LogKey:
    """Make a key; a file that is there already is never written over.

    Raises:
        CannotRead: The file cannot be written.
    """
    secret = secrets.token_bytes(SIZE)
    try:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        descriptor = os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600)
        with open(descriptor, "w", encoding="ascii") as file:
            file.write(secret.hex() + "\n")
            file.flush()
            os.fsync(file.fileno())
    except FileExistsError:  # by another server, a moment ago
        found = read_key(path)
        assert found is not None
        return found
    except OSError as problem:
        raise CannotRead(
            f"cannot write the key of the logs, `{path}`: {problem.strerror}",
            ("name another place: `--log-key FILE`",),
        ) from problem
    return LogKey(path, secret)
