"""The `vrts` command: all commands in sections, each loaded when it is called.

Exit statuses: 0 everything holds, 1 something is wrong, 2 wrong call, 3 undetermined, 70 a fault in
vrts itself; 130 interrupted, 141 the reader of a pipe has left.
"""

import importlib
import sys
from pathlib import Path

import click

from vrts import __version__
from vrts.cli.grammar.ending import Ending, open_streams, run
from vrts.cli.grammar.group import LazyGroup
from vrts.cli.shared.console import guarded, out

SECTIONS = {  # heading: name: where it is, what it does
    "Write programs": {
        "compile": ("language.compile_command", "check a program for mistakes, without running it"),
        "fix": ("language.fix_command", "correct mistakes in a program that have a sure remedy"),
        "fmt": ("language.fmt_command", "write a program in the standard layout"),
        "point": ("authoring.point_command", "ask whether the arm can reach a place"),
        "scene": ("authoring.scene_command", "list, show, check and watch scenes"),
        "new": (
            "authoring.new_command",
            "begin a scene, task, program, lab, environment or scenario",
        ),
        "editor": ("editors.editor_command", "set up VS Code, Neovim and other editors for VAL-II"),
        "lsp": ("editors.lsp_command", "help an editor while you write programs"),
        "dap": ("editors.dap_command", "debug programs from an editor, forward and backward"),
    },
    "Run and verify them": {
        "run": ("runs.run_command", "run a program and print what it prints"),
        "verify": (
            "runs.verify_command",
            "run a program and check everything; mark it if there is a task",
        ),
        "why": (
            "runs.why_command",
            "say why points are lost, back to the step that is the cause",
        ),
        "view": ("runs.view_command", "see a program move"),
        "debug": ("runs.debug_command", "debug a program at the terminal, forward and backward"),
        "monitor": ("runs.monitor_command", "talk to the controller as its operator"),
        "prove": (
            "runs.prove_command",
            "look at every future of a program: all inputs, at every moment",
        ),
        "check-proof": (
            "runs.check_proof_command",
            "check a certificate of `verify`, without trusting either",
        ),
    },
    "Mark a class": {
        "grade": ("grade.grade_command", "mark many submissions"),
        "task": (
            "authoring.task_command",
            "check an assignment, and pack it for students and staff",
        ),
        "purge": ("purge_command", "delete what old markings hold about people"),
    },
    "Share a robot in the browser": {
        "serve": ("live.serve_command", "share sessions in the browser: a class and one robot"),
        "course": (
            "course.course_command",
            "run a course: lists of the class, links for its people",
        ),
        "teach": ("live.teach_command", "move the arm by keys and record locations"),
        "replay": ("live.replay_command", "repeat a live session from its log"),
    },
    "Bring it to a real robot": {
        "dispatch": ("dispatch.dispatch_command", "bring a verified program to a real controller"),
        "validate": (
            "validate.validate_command",
            "compare a real robot with the run of its program",
        ),
    },
    "Look things up": {
        "learn": ("learn_command", "learn in steps of a few minutes: list, copy, check lessons"),
        "help": ("help_command", "show the help of a command: `vrts help grade export`"),
        "manual": (
            "language.manual_command",
            "find a page of the manual, or open it in the browser",
        ),
        "explain": ("language.explain_command", "explain diagnostic codes"),
        "support": ("language.support_command", "show the words of the language"),
        "completion": ("completion_command", "let Bash, Zsh or Fish complete what you type"),
        "schema": ("schema_command", "print the JSON Schema of files you write, and of results"),
    },
}

SAID = {
    heading: {name: says for name, (_, says) in commands.items()}
    for heading, commands in SECTIONS.items()
}

STATUSES = (
    "Exit statuses: 0 everything holds, 1 something is wrong, 2 wrong call, 3 undetermined, "
    "70 a fault in vrts itself, 130 interrupted."
)


class Vrts(Ending, LazyGroup):
    """All commands, of which each says where it is."""

    sections = SAID

    def load(self, ctx: click.Context, name: str) -> click.Command | None:
        """Import and return a command."""
        for commands in SECTIONS.values():
            if name in commands:
                return importlib.import_module(f"vrts.cli.{commands[name][0]}").command
        return None


@click.group(
    cls=Vrts,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog=STATUSES,
)
@click.version_option(__version__, "-V", "--version", prog_name="vrts")
@click.pass_context
@guarded
def vrts(ctx: click.Context) -> None:
    """Compile, simulate, verify and mark VAL-II robot programs."""
    if ctx.invoked_subcommand is None:
        from vrts.learn.standing import standing

        out(standing(Path()).text, end=False)


def main() -> None:
    """Run the command line; the entry point of the package."""
    open_streams()
    sys.exit(run(vrts, "vrts"))


if __name__ == "__main__":
    main()
