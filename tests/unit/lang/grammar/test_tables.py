"""The tables in the package are those of the grammar, and the grammar has no conflict."""

import vrts.lang.grammar.tables
from vrts.lang.grammar.parser import tables_source


def test_tables_are_made_from_the_grammar() -> None:
    path = vrts.lang.grammar.tables.__file__
    with open(path, encoding="utf-8") as file:
        assert file.read() == tables_source()
