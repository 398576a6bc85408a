"""From what seems wrong to what is told: confirmed by a replay, shrunk, with its scenario."""

from contextlib import closing

from vrts.prove.asking import Answers, first_here
from vrts.prove.environment.environment import Environment
from vrts.prove.graph.past import story
from vrts.prove.graph.suspects import Suspect
from vrts.prove.proof import Decided, Wrong, Wronged
from vrts.prove.telling.allowed import allowed
from vrts.prove.telling.confirm import Replays, Shown
from vrts.prove.telling.scenarios import scenario_of
from vrts.prove.telling.shrink import shrunk

MOST = 12  # causes that are told
FORETOLD = (Wrong.LIMIT,)  # said when a motion begins: it may be given up before it comes true


class Teller:
    """Tells what goes wrong in futures of one program."""

    def __init__(self, replays: Replays, environment: Environment, tick_s: float) -> None:
        """Take what replays, and what is the same in every future."""
        self.replays, self.environment, self.tick_s = replays, environment, tick_s
        self.doubtful: list[str] = []  # what a replay does not show
        self.found: list[Wronged] = []  # what replays confirm, the shortest first
        self.asked = 0  # of what seems wrong, as far as answers came

    def tell(self, suspects: list[Suspect], answers: Answers) -> None:
        """Find what replays confirm, the shortest first.

        Args:
            suspects: What seems wrong, the shortest first.
            answers: Asks for each what a replay shows; those behind the last told are not asked.
        """
        found = self.found
        causes: set[tuple[object, ...]] = set()
        doubtful: list[Suspect] = []
        with closing(first_here(answers, self._confirmed, suspects)) as shown_of:
            for suspect, told in zip(suspects, shown_of, strict=True):
                self.asked += 1
                if told is None:
                    if suspect.wrong not in FORETOLD and suspect.certain:
                        doubtful.append(suspect)
                    continue
                where = None if told.cause is None else (told.cause.program, told.cause.step)
                why = (told.wrong, suspect.what[:2], where)  # of contacts: bodies, not their parts
                if why not in causes:
                    causes.add(why)
                    found.append(told)
                if len(found) == MOST:
                    break
        shown = {why[:2] for why in causes}
        for suspect in doubtful:
            if (suspect.wrong, suspect.what[:2]) not in shown:
                self.doubtful.append(suspect.headline)

    def _confirmed(self, suspect: Suspect) -> Wronged | None:
        whole = story(suspect.past)

        def shows(decisions: tuple[Decided, ...]) -> Shown | None:
            until_s = suspect.time_s
            if not allowed(self.environment, decisions, whole, until_s, self.tick_s):
                return None
            scenario = scenario_of(self.environment, decisions, self.tick_s)
            return self.replays.shows(suspect, scenario)

        shown = shows(whole)
        if shown is None:
            return None
        decisions, shown = shrunk(whole, shows, shown)
        scenario = scenario_of(self.environment, decisions, self.tick_s)
        return Wronged(
            suspect.wrong,
            shown.headline,
            shown.time_s,
            shown.cause,
            decisions,
            scenario,
            confirmed=True,
        )
