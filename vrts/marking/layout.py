"""Where marking writes what: `students` may be sent to whom they are about, `staff` may not."""

from pathlib import Path

STUDENTS, STAFF = "students", "staff"
STAGING = ".staging"  # in `staff`: what processes are writing
COMPARED = "similarity"  # in `staff`: programs to compare with, and pages of two of them
DECISIONS = "decisions"  # in `staff`: a file for each grader
RESULT = "result.json"
FORGETTING = ".forgetting"  # in `staff`: who is being forgotten; deleted when that has ended
AGAIN_LOCK = ".again.lock"  # in `staff`: held by a desk that marks again; nothing is in it
LOST = "lost.txt"  # why a process gave no answer, or only the mark


class Layout:
    """The folder of the output of one marking."""

    def __init__(self, root: Path) -> None:
        """Take the folder; nothing is made yet."""
        self.root = root
        self.staff = root / STAFF
        self.staging = self.staff / STAGING
        self.overview = self.staff / "index.html"
        self.results = self.staff / "results.json"
        self.intake = self.staff / "intake.csv"
        self.variants = self.staff / "variants"  # tasks by which students were marked, by tag
        self.overrides = self.staff / "overrides.toml"
        self.decisions = self.staff / DECISIONS

    def student(self, identifier: str) -> Path:
        """Return the folder that may be sent to a student."""
        return self.root / STUDENTS / identifier

    def grader(self, identifier: str) -> Path:
        """Return the folder about a student that stays with those who mark."""
        return self.staff / STUDENTS / identifier


def write_atomically(path: Path, data: bytes) -> None:
    """Write a file so that it is there whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    draft = path.with_name(path.name + ".part")
    draft.write_bytes(data)
    draft.replace(path)
