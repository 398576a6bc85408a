"""The rules of an exam, in plain words for those who sit it."""

from collections.abc import Iterator

from vrts.check.task.task import Task


def exam_words(task: Task) -> Iterator[str]:
    """Yield the rules of the exam, a line each; nothing where the task is no exam."""
    rules = task.late
    if rules is None or rules.opens is None:
        return
    yield f"opens: {rules.opens.isoformat(' ')}; closes: {rules.due.isoformat(' ')}"
    yield "what is handed in before it opens or after it closes does not count"
    if rules.attempts == 1:
        yield "you have one attempt: your first hand-in while the exam is open counts"
    else:
        yield (
            f"you have {rules.attempts} attempts: your first {rules.attempts} hand-ins while the "
            "exam is open count, and the best of them is your mark"
        )
    if task.offline:
        yield "work without a network: nothing here needs one, and vrts loads nothing from one"
