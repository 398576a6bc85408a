from collections.abc import Callable, Sequence
from typing import Generic, TypeVar, overload

import numpy as np
import numpy.typing as npt
from scipy.sparse import csr_matrix

_Array = npt.NDArray[np.float64]
_Jacobian = TypeVar("_Jacobian")

class OptimizeResult(Generic[_Jacobian]):
    x: _Array
    cost: float
    fun: _Array
    jac: _Jacobian

@overload
def least_squares(
    fun: Callable[[_Array], _Array],
    x0: _Array,
    jac: Callable[[_Array], csr_matrix],
    *,
    bounds: tuple[_Array, _Array] = ...,
    x_scale: str | _Array = ...,
    ftol: float = ...,
    xtol: float = ...,
    tr_solver: str = ...,
    max_nfev: int = ...,
) -> OptimizeResult[csr_matrix]: ...
@overload
def least_squares(
    fun: Callable[[_Array], _Array],
    x0: _Array,
    *,
    x_scale: str | _Array = ...,
    loss: str = ...,
    f_scale: float = ...,
) -> OptimizeResult[_Array]: ...
def linear_sum_assignment(
    cost_matrix: npt.NDArray[np.int64], maximize: bool = ...
) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]: ...

class LinearResult:
    x: _Array | None
    fun: float

def linprog(
    c: tuple[float, ...],
    *,
    A_ub: _Array,
    b_ub: _Array,
    bounds: Sequence[tuple[float | None, float | None]],
) -> LinearResult: ...
