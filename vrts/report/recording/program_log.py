"""What the program did and said, line by line, and the summary."""

import rerun as rr

from vrts.engine.memory.events import MotionStarted, Printed
from vrts.report.assessment import Assessment
from vrts.report.event_words import event_text
from vrts.report.first_screen import first_screen
from vrts.report.page.replay_data import contact_sentence
from vrts.report.page.replay_lanes import line_of, robot_lines
from vrts.report.plain import one_line
from vrts.report.quantities import full, mark
from vrts.report.recording.lanes import numbered_line
from vrts.report.recording.names import at_times, plain_markdown
from vrts.report.recording.static import static_chunk

LEVELS = {"fault": "ERROR", "note": "WARN", "output": "INFO"}
LINE_LEVEL = "TRACE"
OTHER_LEVEL = "DEBUG"


def send_log(a: Assessment) -> None:
    """Send every line as it is at work, every event, and contacts, in time order."""
    assert a.run is not None
    rows = [
        (time_s, 0, f"line {numbered_line(a, line)}", LINE_LEVEL)
        for time_s, line in robot_lines(a.run, a.source)
    ]
    for event in a.run.events:
        words = event_text(event)
        if words is None or isinstance(event, MotionStarted):  # its line says the same
            continue
        kind, text = words
        line = line_of(event.cause.span, a.source) if event.cause else 0
        where = f"line {line}  " if line else ""
        said = "TYPE: " if isinstance(event, Printed) else ""
        rows.append((event.time_s, 1, f"{where}{said}{text}", LEVELS.get(kind, OTHER_LEVEL)))
    report = a.judgement.collisions if a.judgement else None
    for contact in report.contacts if report else ():
        rows.append((contact.start_s, 2, f"contact: {contact_sentence(contact)}", "ERROR"))
    rows.sort(key=lambda row: row[:2])
    if rows:
        rr.send_columns(
            "log",
            at_times([row[0] for row in rows]),
            rr.TextLog.columns(text=[row[2] for row in rows], level=[row[3] for row in rows]),
        )


def send_summary(a: Assessment) -> None:
    """Send the answer in one look."""
    screen = first_screen(a)
    out_of = f"**{mark(screen.mark)} of {full(screen.total)}**, " if screen.mark is not None else ""
    ready = f"yes, in {screen.ready_in}" if screen.ready else "no"
    title, cause = plain_markdown(one_line(a.title)), plain_markdown(screen.cause)
    text = f"# {title}\n\n{out_of}ready for the real robot: {ready}\n\n{cause}\n"
    document = rr.TextDocument(text, media_type="text/markdown")
    rr.send_chunks(static_chunk("summary", document))
