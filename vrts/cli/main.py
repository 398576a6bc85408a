"""The `vrts` command: finds the subcommand, loads it, and keeps the exit statuses.

0 everything holds, 1 something is wrong, 2 wrong call, 3 undetermined, 70 a fault in vrts itself.
"""

import importlib
import os
import sys
import traceback

import click

from vrts import __version__

FAULT = 70

COMMANDS = {  # name: where it is, what it does
    "compile": ("language.compile_command", "check a program for mistakes, without running it"),
    "run": ("runs.run_command", "run a program and print what it prints"),
    "verify": (
        "runs.verify_command",
        "run a program and check everything; mark it if there is a task",
    ),
    "why": ("runs.why_command", "tell why points are lost: causes backward to the step to blame"),
    "prove": (
        "runs.prove_command",
        "look at every future of a program: all inputs, at every moment",
    ),
    "check-proof": (
        "runs.check_proof_command",
        "check a certificate that `verify` wrote, trusting neither",
    ),
    "grade": ("grade.grade_command", "mark many submissions"),
    "view": ("runs.view_command", "see a program move"),
    "monitor": ("runs.monitor_command", "talk to the controller as its operator"),
    "teach": ("live.teach_command", "move the arm by keys and record locations"),
    "serve": ("live.serve_command", "share sessions in the browser: a class and one robot"),
    "replay": ("live.replay_command", "repeat a live session from its log"),
    "debug": ("runs.debug_command", "debug a program at the terminal, forward and backward"),
    "dap": ("editors.dap_command", "debug programs from an editor, forward and backward"),
    "editor": ("editors.editor_command", "set up VS Code, Neovim or Emacs for VAL-II"),
    "lsp": ("editors.lsp_command", "help an editor while programs are written"),
    "validate": ("validate.validate_command", "compare a real robot with the run of its program"),
    "new": (
        "authoring.new_command",
        "write a scene, a task, a program or an environment to begin with",
    ),
    "task": ("authoring.task_command", "check an assignment, and pack it for students and staff"),
    "fix": ("language.fix_command", "mend what is certain in a program"),
    "fmt": ("language.fmt_command", "write a program in the canonical layout"),
    "scene": ("authoring.scene_command", "list, show, check and watch scenes"),
    "point": ("authoring.point_command", "ask what the arm can reach"),
    "explain": ("language.explain_command", "explain a diagnostic code"),
    "manual": ("language.manual_command", "open the manual in the browser"),
    "support": ("language.support_command", "show the words of the language"),
    "dispatch": ("dispatch.dispatch_command", "bring a verified program to a real controller"),
    "purge": ("purge_command", "delete what old markings hold about persons"),
    "schema": ("schema_command", "print the JSON Schema of result files"),
}

FIRST_STEPS = """\
check a program:  vrts verify examples/01-cans-on-bases/solution.v2
see it move:      vrts view examples/01-cans-on-bases/solution.v2
mark a class:     vrts grade examples/01-cans-on-bases -o out
find places:      vrts scene show cans-on-bases
explain an error: vrts explain V301
"""

STATUSES = (
    "Exit statuses: 0 everything holds, 1 something is wrong, 2 wrong call, 3 undetermined, "
    "70 a fault in vrts itself."
)


class LazyGroup(click.Group):
    """Loads a subcommand only when it is called, so that `vrts --help` is instant."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of all subcommands in the order of a first day."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import and return a subcommand."""
        if cmd_name not in COMMANDS:
            return None
        module = importlib.import_module(f"vrts.cli.{COMMANDS[cmd_name][0]}")
        return module.command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the subcommands without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, says) for name, (_, says) in COMMANDS.items()])


@click.group(
    cls=LazyGroup,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog=STATUSES,
)
@click.version_option(__version__, prog_name="vrts")
@click.pass_context
def vrts(ctx: click.Context) -> None:
    """Compile, simulate, verify and mark VAL-II robot programs."""
    if ctx.invoked_subcommand is None:
        click.echo(FIRST_STEPS, nl=False)


def main() -> None:
    """Run the command line; the entry point of the package."""
    try:
        vrts(prog_name="vrts")
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # nothing more to flush to
        sys.exit(0)
    except KeyboardInterrupt:
        sys.exit(130)
    except Exception:  # the last line of defence: a fault of ours has its own status
        traceback.print_exc()
        click.echo("vrts itself failed: please report the text above", err=True)
        sys.exit(FAULT)


if __name__ == "__main__":
    main()
