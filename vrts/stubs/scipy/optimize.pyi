from collections.abc import Callable

import numpy as np
import numpy.typing as npt

_Array = npt.NDArray[np.float64]

class OptimizeResult:
    x: _Array
    cost: float
    fun: _Array
    jac: _Array
    success: bool

def least_squares(
    fun: Callable[[_Array], _Array],
    x0: _Array,
    jac: Callable[[_Array], _Array] | str = ...,
    bounds: tuple[_Array, _Array] = ...,
    *,
    x_scale: str | _Array = ...,
    loss: str = ...,
    f_scale: float = ...,
    ftol: float = ...,
    xtol: float = ...,
    max_nfev: int = ...,
) -> OptimizeResult: ...
