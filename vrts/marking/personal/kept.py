"""What a marking keeps of people: one table for the manual, and for whom it is handed out to."""

from typing import Final, NamedTuple

UNTIL: Final = "until `vrts purge`"
AGAIN: Final = "until `vrts purge`, or the next comparison"


class Kept(NamedTuple):
    """One thing that a marking keeps."""

    what: str
    where: str  # in the folder of a marking
    purpose: str
    how_long: str
    handed_out: str  # as what, to whom it is about


KEPT: Final = (
    Kept(
        "names, addresses, ids, when files came",
        "`staff/intake.csv`, `staff/results.json`, `staff/marks.csv`, `staff/index.html`",
        "to know whose a mark is",
        UNTIL,
        "`intake.csv`, `row.json`, `marks.csv`",
    ),
    Kept(
        "who has which pseudonym",
        "`staff/names.csv`, `staff/pseudonyms.key`",
        "to give marks back to their owners",
        UNTIL,
        "`names.csv`",
    ),
    Kept(
        "marks, reports, recordings, feedback",
        "`students`, `staff/students`",
        "to hand out, and to decide appeals",
        UNTIL,
        "`students`, `staff`",
    ),
    Kept(
        "what graders decided and wrote about students, with the graders' names and times",
        "`staff/decisions`, `staff/overrides.toml`; from there in marks, feedback and reports",
        "to make the marks, to repeat them, and to undo a decision",
        UNTIL,
        "`decisions.json`, `changes.json`; without private comments",
    ),
    Kept(
        "programs, and what their runs did, by id",
        "`staff/similarity/programs.zip`, `staff/students/ID/motion.json`",
        "to compare them again, and with later classes",
        UNTIL,
        "`program.v2`, `motion.json`",
    ),
    Kept(
        "two programs side by side, also of earlier years",
        "`staff/similarity/pair-NNN.html`",
        "to look at a group",
        AGAIN,
        "not at all: the other program is somebody else's",
    ),
    Kept(
        "the groups of programs that are alike",
        "`staff/similarity.html`, `staff/similarity.json`",
        "to find copies",
        AGAIN,
        "`likeness.json`, without the others",
    ),
    Kept(
        "who of another folder is who, in a class without names",
        "`staff/similarity/names.csv`",
        "to find them",
        AGAIN,
        "not at all: it is about others",
    ),
    Kept(
        "who has which variant",
        "`staff/variants`, `staff/results.json`",
        "to mark each student by their own one",
        UNTIL,
        "`row.json`; the task with its hidden part stays",
    ),
    Kept(
        "exports",
        "`staff/exports`",
        "to hand in at a platform",
        UNTIL,
        "not at all: they repeat the rest",
    ),
    Kept(
        "how the class was marked: the command, with names of files that were handed in one by one",
        "`staff/marking.json`",
        "to mark again in the same way, and to know how old all this is",
        UNTIL,
        "not at all: what was handed in is in `row.json`",
    ),
    Kept(
        "what a marking was writing when it was interrupted",
        "`staff/.staging`, `staff/.renewing`, `staff/.forgetting`",
        "to go on",
        "until the next call of the same command",
        "not at all: drafts of the rest",
    ),
)


def manual_rows() -> tuple[str, ...]:
    """Return the lines of the manual's table."""
    return tuple(
        f"| {one.what} | {one.where} | {one.purpose} | {one.how_long} | {one.handed_out} |"
        for one in KEPT
    )


def plain_words() -> str:
    """Return the table as text for the person whom it is about."""
    return "\n".join(
        f"{one.what}\n"
        f"    where:    {one.where}\n"
        f"    what for: {one.purpose}\n"
        f"    how long: {one.how_long}\n"
        f"    in here:  {one.handed_out}\n"
        for one in KEPT
    ).replace("`", "")
