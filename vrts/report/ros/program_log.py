"""Lines at work, what the program said and what happened, as `rcl_interfaces/Log`."""

from collections.abc import Iterator

from rosbags.typesys.stores.ros2_humble import rcl_interfaces__msg__Log as Log

from vrts.engine.memory.events import MotionStarted
from vrts.report.assessment import Assessment
from vrts.report.event_words import event_text
from vrts.report.page.replay_data import contact_sentence
from vrts.report.page.replay_lanes import line_of, robot_lines
from vrts.report.plain import one_line
from vrts.report.ros.messages import nanoseconds, stamp

NAME = "vrts"
LEVELS = {"fault": Log.ERROR, "note": Log.WARN, "output": Log.INFO}


def log_messages(a: Assessment) -> Iterator[tuple[int, Log]]:
    """Return a message for each line, event and contact, with its time [ns], in order."""
    assert a.run is not None
    rows: list[tuple[float, int, int, int, str]] = []  # time, order, level, line, words
    if a.source is not None:
        for time_s, line in robot_lines(a.run, a.source):
            words = one_line(a.source.line_text(line).strip()) if line else "(another file)"
            rows.append((time_s, 0, Log.DEBUG, line, words))
    for event in a.run.events:
        found = event_text(event)
        if found is None or isinstance(event, MotionStarted):  # its line says the same
            continue
        line = line_of(event.cause.span, a.source) if event.cause else 0
        rows.append((event.time_s, 1, LEVELS.get(found[0], Log.INFO), line, found[1]))
    report = a.judgement.collisions if a.judgement else None
    for contact in report.contacts if report else ():
        line = line_of(contact.cause.span, a.source) if contact.cause else 0
        rows.append((contact.start_s, 2, Log.ERROR, line, f"contact: {contact_sentence(contact)}"))
    rows.sort(key=lambda row: row[:2])
    title = one_line(a.title)
    for time_s, _, level, line, words in rows:
        time_ns = nanoseconds(time_s)
        yield time_ns, Log(stamp(time_ns), level, NAME, words, title, "", line)
