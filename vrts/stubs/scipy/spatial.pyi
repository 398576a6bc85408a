"""What vrts uses of scipy.spatial."""

from numpy import float64, int32
from numpy.typing import NDArray

class QhullError(RuntimeError): ...

class ConvexHull:
    equations: NDArray[float64]
    neighbors: NDArray[int32]
    simplices: NDArray[int32]
    volume: float
    def __init__(self, points: NDArray[float64]) -> None: ...
