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

COMMANDS = {
    "compile": "check a program for mistakes, without running it",
    "run": "run a program and print what it prints",
    "verify": "run a program and check everything; mark it if there is a task",
    "grade": "mark many submissions",
    "view": "see a program move",
    "monitor": "talk to the controller as its operator",
    "teach": "move the arm by keys and record locations",
    "serve": "share sessions in the browser: a class and one robot",
    "replay": "repeat a live session from its log",
    "debug": "debug a program at the terminal, forward and backward",
    "dap": "debug programs from an editor, forward and backward",
    "editor": "set up VS Code, Neovim or Emacs for VAL-II",
    "lsp": "help an editor while programs are written",
    "validate": "compare a real robot with the run of its program",
    "new": "write a scene, a task or a program to begin with",
    "task": "check an assignment, and pack it for students and staff",
    "fmt": "write a program in the canonical layout",
    "scene": "list, show, check and watch scenes",
    "point": "ask what the arm can reach",
    "explain": "explain a diagnostic code",
    "support": "show the words of the language",
    "dispatch": "bring a verified program to a real controller",
    "purge": "delete what old markings hold about persons",
    "schema": "print the JSON Schema of result files",
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
        module = importlib.import_module(f"vrts.cli.{cmd_name}_command")
        return module.command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the subcommands without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


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
