"""Titles of the columns of Moodle's grading worksheet, in the languages that are known; folded."""

GRADE = frozenset(
    {
        "grade",
        "bewertung",
        "note",
        "calificación",
        "valutazione",
        "cijfer",
        "nota",
        "avaliação",
        "betyg",
        "karakter",
        "ocena",
        "оценка",
        "評点",
        "成绩",
    }
)
COMMENTS = frozenset(
    {
        "feedback comments",
        "feedback als kommentar",
        "feedback par commentaires",
        "comentarios de retroalimentación",
        "commenti di feedback",
        "feedback opmerkingen",
        "comentários de feedback",
    }
)
FULL_NAME = frozenset(
    {
        "full name",
        "vollständiger name",
        "nom complet",
        "nombre completo",
        "nome completo",
        "volledige naam",
    }
)
OTHERS = frozenset({"identifier", "id", "email address", "status", "e-mail-adresse"})
NO = frozenset(
    {"no", "nein", "non", "não", "nee", "nie", "nej", "nei", "ei", "нет", "ні", "いいえ", "否"}
)
KNOWN = GRADE | COMMENTS | FULL_NAME | OTHERS
