"""result.json of Classroom 50: what an `autograder.py` answers about the submission of a run.

Scores there are whole numbers, so a mark of 8.5 is 85 of 100. All of it is one test; the checks
that the student sees say whether they hold, without points of their own.
"""

from collections.abc import Mapping

from vrts.base.diagnostic import Rule, error
from vrts.marking.exports.autograders.gradescope import to_bytes
from vrts.marking.exports.given import Given, Options, Product, Returned, returned
from vrts.marking.exports.steps import NOTHING
from vrts.pipeline.refused import Refused
from vrts.report.plain import one_line

NO_RUN = Rule("V751", "no-run-of-classroom50")

SCHEMA = "classroom50/result/v1"
VARIABLES = {
    "classroom": "CLASSROOM",
    "assignment": "ASSIGNMENT",
    "submission": "SUBMISSION_TAG",
    "commit": "COMMIT_URL",
    "release": "RELEASE_URL",
}  # what the runner tells an autograder; it adds owner and kind of assignment itself
REVIEW = "REVIEW_URL"  # optional: otherwise the commit
POINTS = 10  # that one point of a mark is worth there
MOST_TESTS = 100
LONGEST = 100  # bytes of the name of a test
TIME = "%Y-%m-%dT%H:%M:%SZ"

Json = dict[str, object]


def classroom50(given: Given, options: Options) -> Product:
    """Return the document of the one submission of a run.

    Raises:
        Refused: This is no run of Classroom 50, or there is not just one submission.
    """
    environment = options.environment
    missing = [name for name in VARIABLES.values() if not environment.get(name)]
    if missing or options.now is None:
        names = ", ".join(f"`{name}`" for name in missing)
        raise _no_run(f"this is no run of Classroom 50: {names} is not set")
    if len(given.whole.rows) != 1:
        raise _no_run(f"a run is of one submission, not of {len(given.whole.rows)}")
    (told,) = returned(given)
    document = {
        "schema": SCHEMA,
        **{field: environment[name] for field, name in VARIABLES.items()},
        "review": environment.get(REVIEW) or environment[VARIABLES["commit"]],
        "datetime": options.now.strftime(TIME),
        **scores(told),
    }
    return Product([(f"classroom50/{told.row.id}.json", to_bytes(document))])


def scores(told: Returned) -> Json:
    """Return score and tests of a submission; the tests add up to the score."""
    final = told.row.exact_final or NOTHING
    full = told.row.result.exact_total
    score, most = int(final * POINTS), int(full * POINTS)
    whole = {"test-name": "mark", "passed": final == full, "score": score, "max-score": most}
    checks = [check for check in told.public.checks if check.kind != "rounding"]
    return {
        "score": score,
        "max-score": most,
        "tests": [
            whole,
            *(
                {
                    "test-name": _name(check.title),
                    "passed": check.answer == "holds",
                    "score": 0,
                    "max-score": 0,
                }
                for check in checks[: MOST_TESTS - 1]
            ),
        ],
    }


def from_environment(environment: Mapping[str, str]) -> dict[str, str]:
    """Return the variables that count, and no others."""
    return {name: environment.get(name, "") for name in (*VARIABLES.values(), REVIEW)}


def _name(title: str) -> str:
    return one_line(title).encode()[:LONGEST].decode(errors="ignore") or "check"


def _no_run(headline: str) -> Refused:
    remedy = "call it from the `autograder.py` of an assignment, which has these variables"
    return Refused((error(NO_RUN, headline, help=(remedy,)),))
