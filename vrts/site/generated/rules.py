"""Which rules of the language speak of a word."""

import re
from pathlib import Path

from vrts.ask.rules import Rule, rules_in


def rules_of(folder: Path) -> tuple[Rule, ...]:
    """Return the rules of all pages in a folder of the manual."""
    return tuple(
        rule
        for page in sorted(folder.glob("*.md"))
        for rule in rules_in(f"{folder.name}/{page.stem}", page.read_text("utf-8"))
    )


def about(word: str, rules: tuple[Rule, ...], most: int = 3) -> list[Rule]:
    """Return the rules that speak of a word, those that have it in their titles first."""
    whole = re.compile(rf"(?<![\w.$#]){re.escape(word)}(?![\w]|\.\w)")

    def weight(rule: Rule) -> int:
        return (
            4 * bool(whole.search(rule.title))
            + 2 * bool(whole.search(rule.prose))
            + bool(whole.search(rule.blocks))
        )

    speaking = sorted((rule for rule in rules if weight(rule)), key=weight, reverse=True)
    return speaking[:most]
