"""The layout of memory: which number every global variable has, and what it stands for."""

from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Memory


class Layout:
    """Gives every global variable its number in memory."""

    def __init__(self) -> None:
        """Start with no variable."""
        self.names: list[str] = []  # by number
        self.numbers: dict[str, int] = {}
        self.arrays: set[str] = set()

    def copy(self) -> "Layout":
        """Return a layout that goes on by itself."""
        other = Layout()
        other.names = self.names.copy()
        other.numbers, other.arrays = dict(self.numbers), set(self.arrays)
        return other

    def number(self, name: str) -> int:
        """Return the number of a global variable, a new one at first."""
        number = self.numbers.get(name)
        if number is None:
            number = self.numbers[name] = len(self.names)
            self.names.append(name)
        return number

    def fresh(self, since: int = 0) -> list[Bound]:
        """Return fresh memory for all of them, or for those from a number on."""
        arrays = self.arrays
        return [Array(name) if name in arrays else Cell(name) for name in self.names[since:]]

    def extend(self, memory: Memory) -> None:
        """Give memory the variables that it does not have yet; what is new costs, not what is."""
        known = len(memory.bound)
        memory.bound += self.fresh(known)
        for name in self.arrays:
            number = self.numbers.get(name, known)
            if number < known:
                bound = memory.bound[number]
                if isinstance(bound, Cell) and bound.value is UNDEFINED:
                    memory.bound[number] = Array(name)

    def variable(self, memory: Memory, name: str, subscripts: tuple[int, ...]) -> Cell:
        """Return the cell of a variable, making it when it is new."""
        if subscripts:
            self.arrays.add(name)
        number = self.number(name)
        if number >= len(memory.bound):
            memory.bound += self.fresh(len(memory.bound))
        bound = memory.bound[number]
        if subscripts:
            if isinstance(bound, Cell):
                bound = memory.bound[number] = Array(name)
            return bound.element(subscripts)
        if isinstance(bound, Array):
            bound = memory.bound[number] = Cell(name)
        return bound

    def bound(self, memory: Memory, name: str) -> Bound | None:
        """Return what a name stands for; None when it was never spoken of."""
        number = self.numbers.get(name)
        return memory.bound[number] if number is not None else None
