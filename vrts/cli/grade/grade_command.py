"""`vrts grade`: marking is what it does unless the first word is one of its subcommands."""

import click

from vrts.cli.grammar.group import LazyGroup

SUBCOMMANDS = {
    "intake": "list who handed in what, in a table that you can edit",
    "plan": "divide a class into shards for other machines",
    "run": "mark one shard, on any machine",
    "merge": "bring the results of shards together",
    "export": "write grade books, feedback and results for other systems",
    "init": "write an autograder for a platform",
    "evidence": "pack everything that a mark rests on, for an appeal",
    "person": "pack all that markings keep of one student",
    "reproduce": "mark what is in an evidence zip again, and compare",
    "diff": "compare two markings of a class",
    "change": "change a mark by hand",
    "decisions": "list what graders decided, undo it, or decide a conflict",
    "desk": "go through a marked class on one page",
    "similarity": "compare the programs of a marking again, also with other folders",
    "session": "mark sessions of the live server",
}
ROOMS = {
    **dict.fromkeys(("plan", "run", "merge"), "machines"),
    **dict.fromkeys(("evidence", "reproduce"), "appeals"),
}
MARK = "mark"
SESSION = "session"
SECTIONS = {"Commands": {MARK: "mark submissions by a task", **SUBCOMMANDS}}


class GradeGroup(LazyGroup):
    """Takes a first word that is no subcommand for the task to mark by."""

    folder = "vrts.cli.grade"
    sections = SECTIONS
    rooms = ROOMS

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put in the name of the subcommand that is left out."""
        if ctx.resilient_parsing and not args:  # a shell asks what may be typed
            return super().parse_args(ctx, args)
        if not args or (args[0] not in SUBCOMMANDS and args[0] != MARK):
            of_sessions = any(word.split("=")[0] == f"--{SESSION}" for word in args)
            args = [SESSION if of_sessions else MARK, *args]
        return super().parse_args(ctx, args)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the subcommand; marking is named as it is called, without a name of its own."""
        name, found, rest = super().resolve_command(ctx, args)
        return ("" if name == MARK else name), found, rest


@click.group(name="grade", cls=GradeGroup)
def command() -> None:
    """Mark many submissions."""
