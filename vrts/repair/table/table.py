"""All candidates of the table, cheapest first."""

from vrts.repair.edit import Candidate
from vrts.repair.table.asked import Asked
from vrts.repair.table.data.together import rows_together
from vrts.repair.table.data.untaught import untaught
from vrts.repair.table.habits import as_usual
from vrts.repair.table.names import other_names
from vrts.repair.table.numbers import other_numbers
from vrts.repair.table.rows import other_rows
from vrts.repair.table.steps import other_steps
from vrts.repair.table.ways import turned_round
from vrts.repair.table.words import other_words


def candidates(asked: Asked) -> list[Candidate]:
    """Return every candidate, cheapest first; of one price in the order of the table."""
    found = [
        *as_usual(asked),
        *turned_round(asked),
        *other_words(asked),
        *other_numbers(asked),
        *other_rows(asked),
        *rows_together(asked),
        *untaught(asked),
        *other_names(asked),
        *other_steps(asked),
    ]
    return sorted((c for c in found if c.change.edits), key=lambda c: round(c.cost, 6))
