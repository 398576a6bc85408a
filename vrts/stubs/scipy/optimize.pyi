from collections.abc import Callable
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
