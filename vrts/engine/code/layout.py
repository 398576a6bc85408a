"""The layout of memory: which number every global variable has, and what it stands for."""

from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Memory


class Layout:
    """Gives every global variable its number in memory."""

    def __init__(self) -> None:
        """Start with no variable."""
        self.numbers: dict[str, int] = {}
        self.arrays: set[str] = set()

    def copy(self) -> "Layout":
        """Return a layout that goes on by itself."""
        other = Layout()
        other.numbers, other.arrays = dict(self.numbers), set(self.arrays)
        return other

    def number(self, name: str) -> int:
        """Return the number of a global variable, a new one at first."""
        return self.numbers.setdefault(name, len(self.numbers))

    def fresh(self) -> list[Bound]:
        """Return fresh memory for all of them."""
        return [Array(name) if name in self.arrays else Cell(name) for name in self.numbers]

    def extend(self, memory: Memory) -> None:
        """Give memory the variables that it does not have yet."""
        fresh = self.fresh()
        for k, bound in enumerate(memory.bound):
            if isinstance(fresh[k], Array) and isinstance(bound, Cell) and bound.value is UNDEFINED:
                memory.bound[k] = fresh[k]
        memory.bound += fresh[len(memory.bound) :]

    def variable(self, memory: Memory, name: str, subscripts: tuple[int, ...]) -> Cell:
        """Return the cell of a variable, making it when it is new."""
        if subscripts:
            self.arrays.add(name)
        number = self.number(name)
        self.extend(memory)
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
