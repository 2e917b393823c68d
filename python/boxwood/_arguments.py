# SPDX-License-Identifier: Apache-2.0
"""Turns what a caller gives into the arrays that the compiled part takes, or says what is wrong."""

from __future__ import annotations

import operator
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
    try:
        if hasattr(value, "__dlpack__") and not hasattr(value, "__array__"):
            return np.from_dlpack(value)  # type: ignore[arg-type]
        return np.asarray(value)
    except (
        AttributeError,
        BufferError,
        OverflowError,
        RuntimeError,
        TypeError,
        ValueError,
    ) as error:
        raise TypeError(f"{name}: found {describe(value)}, expected an array of numbers") from error


def floats(value: ArrayLike, name: str) -> Floats:
    """An array of float32 or float64. Lists of Python's numbers become float64; arrays of integers
    are refused, as they are seldom meant as coordinates."""
    result = array(value, name)
    if result.dtype.newbyteorder("=") in (np.float64, np.float32):
        return _readable(result)
    is_array = hasattr(value, "dtype")
    if result.dtype == np.float16:
        return result.astype(np.float32)
    if not is_array and (result.dtype.kind in "iuf" or result.size == 0):
        return result.astype(np.float64)
    hint = "; convert it with .astype(float)" if result.dtype.kind in "iu" else ""
    raise TypeError(f"{name}: found {describe(result)}, expected float32 or float64{hint}")


def _readable(given: Floats) -> Floats:
    """The array, or a copy if the compiled part can't read it where it is: in another byte order,
    or as part of records, away from multiples of its size."""
    steps_fit = all(step % given.itemsize == 0 for step in given.strides)
    if given.dtype.isnative and given.flags.aligned and steps_fit:
        return given
    return np.array(given, dtype=given.dtype.newbyteorder("="), order="C")


def vectors(value: ArrayLike, name: str) -> Floats:
    """Floats of shape (..., 3)."""
    result = floats(value, name)
    if result.size == 0 and result.ndim == 1:
        return result.reshape(0, 3)
    if result.ndim == 0 or result.shape[-1] != 3:
        raise ValueError(f"{name}: found {describe(result)}, expected shape (..., 3)")
    return result


def points(value: ArrayLike, name: str = "points") -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """The points as rows in double, and the shape of what is found for them."""
    given = vectors(value, name)
    rows = np.ascontiguousarray(given.reshape(-1, 3), dtype=np.float64)
    return rows, given.shape[:-1]


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


def _between(value: ArrayLike, name: str, lowest: int, highest: int) -> NDArray[Any]:
    """Integers within bounds."""
    result = integers(value, name)
    if result.size and (int(result.min()) < lowest or int(result.max()) > highest):
        bad = result[(result < lowest) | (result > highest)].flat[0]
        place = np.argwhere(result == bad)[0]
        where = f" at {tuple(int(i) for i in place)}" if result.ndim else ""
        raise ValueError(
            f"{name}: found {int(bad)}{where}, expected integers from {lowest} to {highest}"
        )
    return result


def int32(value: ArrayLike, name: str, lowest: int = 0) -> NDArray[np.int32]:
    """Integers from `lowest` on that 32 bits hold."""
    return _between(value, name, lowest, 2**31 - 1).astype(np.int32, copy=False)


def uint32(value: ArrayLike, name: str) -> NDArray[np.uint32]:
    """Integers of 32 bits, as masks are."""
    return _between(value, name, 0, 2**32 - 1).astype(np.uint32, copy=False)


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
    is_one = isinstance(value, (int, float)) and not isinstance(value, bool)
    result: NDArray[Any] = np.asarray(number(value, name)) if is_one else array(value, name)
    if result.dtype.kind not in "iuf":
        raise TypeError(f"{name}: found {describe(result)}, expected numbers")
    # What is too large for float is infinite there, and no cause for a warning.
    with np.errstate(over="ignore"):
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


def text(value: str, name: str) -> str:
    """A string of characters, without halves of them."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: found {describe(value)}, expected a str")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise ValueError(f"{name}: found {value!a}, expected Unicode characters") from None
    return value


def flag(value: bool, name: str) -> bool:
    """True or False."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name}: found {describe(value)}, expected True or False")
    return bool(value)


def number(value: Any, name: str) -> float:
    """One real number."""
    if isinstance(value, (bool, np.bool_, str, bytes, bytearray)):
        raise TypeError(f"{name}: found {describe(value)}, expected a number")
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name}: found {describe(value)}, expected a number") from None


def count(value: int, name: str, lowest: int = 0, highest: int = 2**31 - 1) -> int:
    """An integer within bounds."""
    try:
        result = operator.index(value)
    except TypeError:
        result = None
    if result is None or isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name}: found {describe(value)}, expected an integer")
    if not lowest <= result <= highest:
        # Python refuses to write out numbers of thousands of digits.
        found = result if abs(result) < 2**64 else "one of more than 64 bits"
        raise ValueError(f"{name}: found {found}, expected an integer from {lowest} to {highest}")
    return result
