"""`vrts serve`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.live import person
from vrts.cli.live.service import folder_of_key, print_service
from vrts.cli.live.ways_in import Change, change_ways_in
from vrts.cli.shared.console import INTERRUPTED, WRONG, fail, guarded, say, warn
from vrts.cli.shared.options import file_option, lab_option

if TYPE_CHECKING:
    from vrts.course.course import Course

EPILOG = """\b
Examples:
  vrts serve cans-on-bases
  vrts serve examples/01-cans-on-bases final-project --host 0.0.0.0 --rooms groups.txt
  vrts serve robotics-2026 --host 0.0.0.0
  vrts serve --folder vrts-live --backup monday.sqlite
"""


@click.command(name="serve", epilog=EPILOG)
@click.argument("scenes", nargs=-1)
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen at.")
@click.option(
    "--port",
    type=click.IntRange(0, 65_535),
    default=8000,
    show_default=True,
    help="Port; 0 takes any.",
)
@file_option(
    "--folder",
    default=Path("vrts-live"),
    show_default=True,
    help="Folder for what is kept: accounts, rooms, logs, users' files.",
)
@lab_option
@file_option("--rooms", help="File with the names of rooms, one on each line.")
@click.option("--name", "names", multiple=True, help="Name under which browsers find the server.")
@file_option("--tls-cert", help="Certificate, for https.")
@file_option("--tls-key", help="Key of the certificate, for https.")
@click.option("--behind-proxy", is_flag=True, help="A proxy on this machine does https.")
@click.option("--no-code", is_flag=True, help="No class code: links and accounts only.")
@click.option(
    "--turn", type=click.IntRange(0), default=0, help="Longest turn [s] while others wait."
)
@click.option("--idle", type=click.IntRange(0), default=120, help="Longest idle time [s].")
@click.option(
    "--history-quota",
    metavar="MB",
    type=click.IntRange(1),
    default=64,
    show_default=True,
    help="Space for a session's history older than ten minutes.",
)
@click.option(
    "--log-quota",
    metavar="MB",
    type=click.IntRange(1),
    default=256,
    show_default=True,
    help="Space for the log of a session.",
)
@click.option(
    "--private-rooms",
    type=click.IntRange(0, 64),
    default=8,
    show_default=True,
    help="How many private rooms there may be at once.",
)
@click.option("--students-reset", is_flag=True, help="Operators may reset and rewind.")
@click.option("--add-user", metavar="NAME", help="Add an account, ask for its password, and end.")
@click.option("--supervisor", is_flag=True, help="The added account may supervise.")
@click.option("--purge-user", metavar="NAME", help="Forget a user everywhere, and end.")
@click.option(
    "--purge-mentions",
    is_flag=True,
    help="With --purge-user: also forget others' texts that hold the name.",
)
@click.option("--export-user", metavar="NAME", help="Pack all that is kept of a user, and end.")
@file_option("-o", "--output", help="Zip for `--export-user`; without it NAME.zip.")
@click.option("--verify-logs", is_flag=True, help="Check all logs and their signatures, and end.")
@click.option("--accept-logs", is_flag=True, help="Sign the logs as they are, and end.")
@file_option("--log-key", help="File with the key that signs the logs, outside of the folder.")
@file_option("--backup", help="Copy the database, and end.")
@click.option("--ways-in", is_flag=True, help="List the class code and all links, and end.")
@click.option("--renew-code", is_flag=True, help="Replace the class code, and end.")
@click.option("--end-way", metavar="ID", help="End a link or the class code, and end.")
@click.option(
    "--send-away",
    is_flag=True,
    help="With --renew-code or --end-way: also send away all who came in by it.",
)
@click.option("--supervisor-link", is_flag=True, help="Print a supervisor's link, once, and end.")
@click.option("--service", is_flag=True, help="Print a unit for systemd that runs this, and end.")
@guarded
def command(
    scenes: tuple[str, ...],
    host: str,
    port: int,
    folder: Path,
    lab: Path | None,
    rooms: Path | None,
    names: tuple[str, ...],
    tls_cert: Path | None,
    tls_key: Path | None,
    behind_proxy: bool,
    no_code: bool,
    turn: int,
    idle: int,
    history_quota: int,
    log_quota: int,
    private_rooms: int,
    students_reset: bool,
    add_user: str | None,
    supervisor: bool,
    purge_user: str | None,
    purge_mentions: bool,
    export_user: str | None,
    output: Path | None,
    verify_logs: bool,
    accept_logs: bool,
    log_key: Path | None,
    backup: Path | None,
    ways_in: bool,
    renew_code: bool,
    end_way: str | None,
    send_away: bool,
    supervisor_link: bool,
    service: bool,
) -> None:
    """Share sessions in the browser: a class works with one virtual robot together.

    SCENES are names or files of scenes, task files, or folders with a task. The supervisor chooses
    among them. Students open the page and type the class code. One folder with `course.toml` serves
    a course: its people, its rooms, its assignments.

    Somebody who was sent away cannot enter that room again until the supervisor allows it. A user
    is known by the account, a guest by browser and name. A class code lets in everybody who knows
    it: with another browser and another name you are another guest. If that matters, use
    `--no-code`, accounts and join links.

    After a crash, start it with the same folder. Every room goes on where it was, with arm and
    programs stopped: the server repeats exactly what the log says. If it cannot, because the scene
    has changed or somebody was purged, the room begins again and says why. A session whose process
    dies goes on in the same way. If it dies four times in a row, the supervisor chooses how to go
    on. A room whose scene is not among SCENES keeps its log and waits until it is.

    You can rewind a session to any moment and save it as a program. What is older than ten minutes
    goes to a file. When the file reaches `--history-quota`, the server forgets the oldest part. It
    never cuts the log. When that reaches `--log-quota`, the server refuses every command except
    panic, until the supervisor chooses the scene again, which begins another session. It tells the
    room of both.

    Everybody can look at any moment of a session's past, and go on from there in a private room.
    Each person has one at most. It ends when nobody has been in it for five minutes, and its log
    stays. `--private-rooms` says how many there may be. Supervisors can see and close them.

    It listens on this machine only, unless `--host` names another address. For https give
    `--tls-cert` and `--tls-key`, or put a proxy in front of it and start it with `--behind-proxy
    --name lab.example.org`. `vrts manual server` shows the lines that nginx and Caddy need.

    To leave it running, `--service` prints a unit for systemd with the same options. `/health`
    tells whether it is well, and a supervisor with an account sees more at `/admin`. `vrts manual
    server` shows all steps, from an empty machine to the end of a term.
    """
    if purge_mentions and not purge_user:
        fail("`--purge-mentions` goes with `--purge-user`")
    if output is not None and not export_user:
        fail("`--output` goes with `--export-user`")
    if add_user or purge_user or export_user or verify_logs or accept_logs or backup:
        from vrts.live.settings import DATABASE
        from vrts.live.store.unusable import in_one_sentence, require_ours, require_whole

        with in_one_sentence(folder / DATABASE):
            require_ours(folder / DATABASE)
            require_whole(folder / DATABASE)
            if add_user or backup:
                administer(folder, add_user, backup, supervisor=supervisor)
            if export_user:
                person.export_user(folder, export_user, output)
            if purge_user:
                person.purge_user(folder, purge_user, log_key, mentions=purge_mentions)
            if accept_logs or verify_logs:
                check_logs(folder, log_key, accept=accept_logs, verify=verify_logs)
        return
    if ways_in or renew_code or end_way or supervisor_link:
        change_ways_in(
            folder,
            Change(renew=renew_code, end=end_way or "", away=send_away, link=supervisor_link),
        )
        return
    if send_away:
        fail("`--send-away` goes with `--renew-code` or `--end-way`")
    if not scenes:
        fail("which scenes should be served?", ("such as `vrts serve cans-on-bases`",))
    if (tls_cert is None) != (tls_key is None):
        fail("`--tls-cert` and `--tls-key` go together")
    if service:
        keys = () if log_key is None else (folder_of_key(log_key, folder),)
        print_service(click.get_current_context(), (folder, *keys), port)
        return
    try:
        from vrts.live.serving import Listening, serve
    except ModuleNotFoundError as missing:
        hint = "install them with `pip install 'vrts[live]'`"
        fail(f"the live server needs the package {missing.name}", (hint,), WRONG)
    from vrts.live.places import places_of, with_variants
    from vrts.live.settings import Settings
    from vrts.pipeline.files import read_bytes

    course = course_of(scenes, lab, rooms)
    lines = read_bytes(rooms).decode(errors="replace").splitlines() if rooms else ["Class"]
    named = tuple(line.strip() for line in lines if line.strip())
    adding = None
    if course is None:
        places = places_of(scenes, lab)
    else:
        from vrts.course.front.served import adding as added_by
        from vrts.course.places import places_of_course

        places, named, adding = places_of_course(course), course.rooms, added_by(course)
        no_code = no_code or not course.guests
    settings = Settings(
        folder,
        places,
        names,
        students_reset=students_reset,
        idle_s=float(idle),
        turn_s=float(turn),
        history_quota=history_quota * 1_000_000,
        log_quota=log_quota * 1_000_000,
        log_key=log_key,
        private_rooms=private_rooms,
    )
    shared = "rooms" if course is None else "each student has one; rooms that all share"
    for name in with_variants(settings.places):
        say(f"note: `{name}` has variants: {shared} get it as it is written, the same for all")
    listening = Listening(host, port, tls_cert, tls_key, behind_proxy)
    try:
        # its result are the ways in
        serve(settings, listening, named, warn, with_code=not no_code, adding=adding)
    except KeyboardInterrupt:  # how it ends: no word about it
        sys.exit(INTERRUPTED)


def course_of(scenes: tuple[str, ...], lab: Path | None, rooms: Path | None) -> "Course | None":
    """Return the course that is to be served; None: they are scenes.

    Raises:
        CannotRead: Its file cannot be read.
        Refused: It has errors.
    """
    from vrts.course.course_file import is_course, open_course

    found = [name for name in scenes if is_course(Path(name))]
    if not found:
        return None
    if len(scenes) > 1:
        fail(f"`{found[0]}` is a course: it is served alone", ("it names its scenes itself",))
    for given, option in ((lab, "--lab"), (rooms, "--rooms")):
        if given is not None:
            fail(f"`{option}` does not go with a course", ("write it into `course.toml`",))
    return open_course(Path(found[0]))


def administer(
    folder: Path,
    add_user: str | None,
    backup: Path | None,
    *,
    supervisor: bool,
) -> None:
    """Do what the options ask for to a folder."""
    from vrts.live import administration

    if add_user:
        from vrts.live.new_account import add_user as add_account

        password = click.prompt("password", hide_input=True, confirmation_prompt=True, err=True)
        try:
            name = add_account(folder, add_user, password, supervisor=supervisor)
        except ValueError as problem:
            fail(str(problem))
        say(f"there is an account `{name}` now")
        return
    if not (folder / "live.sqlite").is_file():
        fail(f"there is no server's database in `{folder}`")
    if backup:
        administration.save_backup(folder, backup)
        say(f"copied to {backup}")


def check_logs(folder: Path, key: Path | None, *, accept: bool, verify: bool) -> None:
    """Accept the logs of a folder, check them, or both."""
    from vrts.live import administration

    if not (folder / "live.sqlite").is_file():
        fail(f"there is no server's database in `{folder}`")
    if accept:
        accepted = administration.accept_logs(folder, key)
        for text in accepted:
            warn(f"accepted: {text}")
        if not accepted:
            say("there was nothing to accept")
    if verify:
        wrong = False
        for found in administration.verify_logs(folder, key):
            wrong |= found.wrong
            room = f"{found.room} ({found.name}): " if found.name else f"{found.room}: "
            warn(f"{room if found.room else ''}{found.text}")
        if wrong:
            raise SystemExit(WRONG)
