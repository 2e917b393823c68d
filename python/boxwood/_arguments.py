# SPDX-License-Identifier: Apache-2.0
"""Turns what a caller gives into the arrays that the compiled part takes, or says what is wrong."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.floating[Any]]


def describe(value: object) -> str:
    """What was found, for messages."""
    if isinstance(value, np.ndarray):
        return f"an array of {value.dtype} of shape {value.shape}"
    return f"{type(value).__name__}"


def array(value: ArrayLike, name: str) -> NDArray[Any]:
    """The value as an array, without a copy where it is one: of numpy, or by the array interface,
    DLPack or the buffer protocol."""
    if isinstance(value, np.ndarray):
        return value
    try:
        if hasattr(value, "__dlpack__") and not hasattr(value, "__array__"):
            return np.from_dlpack(value)  # type: ignore[arg-type]
        return np.asarray(value)
    except (ValueError, TypeError, RuntimeError, BufferError, OverflowError) as error:
        raise TypeError(f"{name}: found {describe(value)}, expected an array of numbers") from error


def floats(value: ArrayLike, name: str) -> Floats:
    """An array of float32 or float64. Lists of Python's numbers become float64; arrays of integers
    are refused, as they are seldom meant as coordinates."""
    result = array(value, name)
    if result.dtype == np.float64 or result.dtype == np.float32:
        return result if result.dtype.isnative else result.astype(result.dtype.newbyteorder("="))
    is_array = result is value or hasattr(value, "dtype")
    if result.dtype == np.float16:
        return result.astype(np.float32)
    if not is_array and (result.dtype.kind in "iuf" or result.size == 0):
        return result.astype(np.float64)
    hint = "; convert it with .astype(float)" if result.dtype.kind in "iu" else ""
    raise TypeError(f"{name}: found {describe(result)}, expected float32 or float64{hint}")


def vectors(value: ArrayLike, name: str) -> Floats:
    """Floats of shape (..., 3)."""
    result = floats(value, name)
    if result.size == 0 and result.ndim == 1:
        return result.reshape(0, 3)
    if result.ndim == 0 or result.shape[-1] != 3:
        raise ValueError(f"{name}: found {describe(result)}, expected shape (..., 3)")
    return result


def vector(value: ArrayLike, name: str) -> NDArray[np.float64]:
    """Three finite numbers in double."""
    result = floats(value, name)
    if result.shape != (3,) or not np.isfinite(result).all():
        raise ValueError(f"{name}: found {describe(result)}, expected three finite numbers")
    return np.ascontiguousarray(result, dtype=np.float64)


def integers(value: ArrayLike, name: str) -> NDArray[Any]:
    """An array of integers."""
    result = array(value, name)
    if result.size == 0 and not hasattr(value, "dtype"):
        return result.astype(np.int32)
    if result.dtype.kind not in "iu":
        raise TypeError(f"{name}: found {describe(result)}, expected integers")
    return result


def int32(value: ArrayLike, name: str, lowest: int = 0) -> NDArray[np.int32]:
    """Integers from `lowest` on that 32 bits hold."""
    result = integers(value, name)
    if result.dtype == np.int32 and lowest <= -(2**31):
        return result
    if result.size and (int(result.min()) < lowest or int(result.max()) > 2**31 - 1):
        bad = result[(result < lowest) | (result > 2**31 - 1)].flat[0]
        place = np.argwhere(result == bad)[0]
        where = f" at {tuple(int(i) for i in place)}" if result.ndim else ""
        raise ValueError(
            f"{name}: found {int(bad)}{where}, expected integers from {lowest} to 2**31 - 1"
        )
    return result.astype(np.int32, copy=False)


def faces(value: ArrayLike, name: str = "faces") -> NDArray[np.int32]:
    """Indices of shape (n, 3)."""
    result = integers(value, name)
    if result.size == 0 and result.ndim < 2:
        result = result.reshape(0, 3)
    if result.ndim != 2 or result.shape[1] != 3:
        raise ValueError(f"{name}: found {describe(result)}, expected shape (n, 3)")
    return int32(result, name)


def per_item(
    value: ArrayLike, name: str, shape: tuple[int, ...], dtype: type[np.generic]
) -> NDArray[Any]:
    """One number for each of the items, or one for all, as a flat array of the type; the one isn't
    repeated in memory."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        result: NDArray[Any] = np.asarray(value, dtype=np.float64)
    else:
        result = array(value, name)
    if result.dtype.kind not in "iuf":
        raise TypeError(f"{name}: found {describe(result)}, expected numbers")
    result = result.astype(dtype, copy=False)
    try:
        result = np.broadcast_to(result, shape)
    except ValueError:
        raise ValueError(
            f"{name}: found shape {result.shape}, expected one number or shape {shape}"
        ) from None
    return result.reshape(-1)


def path(value: str | os.PathLike[str], name: str = "path") -> str:
    """The name of a file."""
    try:
        result = os.fspath(value)
    except TypeError:
        raise TypeError(f"{name}: found {describe(value)}, expected a str or os.PathLike") from None
    if not isinstance(result, str):
        result = os.fsdecode(result)
    if "\0" in result:
        raise ValueError(f"{name}: found a zero byte, expected the name of a file")
    return result


def number(value: float, name: str) -> float:
    """One real number."""
    if isinstance(value, (bool, str, bytes)):
        raise TypeError(f"{name}: found {describe(value)}, expected a number")
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name}: found {describe(value)}, expected a number") from None


def count(value: int, name: str, lowest: int = 0, highest: int = 2**31 - 1) -> int:
    """An integer within bounds."""
    try:
        result = value.__index__()
    except AttributeError:
        raise TypeError(f"{name}: found {describe(value)}, expected an integer") from None
    if isinstance(value, bool) or not lowest <= result <= highest:
        raise ValueError(f"{name}: found {value}, expected an integer from {lowest} to {highest}")
    return result
