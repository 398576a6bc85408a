"""The files of a session: every user has a folder of their own, all together a quota."""

from pathlib import Path

from vrts.monitor.folder import CannotUse, WorkingFolder

MOST_FILES = 200  # of a user


class UserFolder(WorkingFolder):
    """The folder of one user; what is written counts against the quota of the session."""

    def __init__(self, root: Path, everything: Path, quota: int) -> None:
        """Take a folder that exists, the folder of all users, and how many bytes these may use."""
        super().__init__(root)
        self._everything = everything
        self._quota = quota

    def write(self, name: str, data: bytes, *, replace: bool) -> None:
        """Write a file whole or not at all."""
        used = sum(path.stat().st_size for path in self._everything.glob("*/*"))
        if used + len(data) > self._quota:
            raise CannotUse("Not enough storage area", "the folders of this session are full")
        if len(self.entries()) >= MOST_FILES and not self.exists(name):
            raise CannotUse("Not enough storage area", f"a user has at most {MOST_FILES} files")
        super().write(name, data, replace=replace)


class Folders:
    """The folders of all users."""

    def __init__(self, root: Path, quota: int) -> None:
        """Take a folder that exists."""
        self._root = root
        self._quota = quota

    def of(self, owner: str) -> UserFolder:
        """Return the folder of a user, whose name is safe as a file name."""
        folder = self._root / owner
        folder.mkdir(mode=0o700, exist_ok=True)
        return UserFolder(folder, self._root, self._quota)
