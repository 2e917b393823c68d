# SPDX-License-Identifier: Apache-2.0
"""Pictures from arrays."""

from __future__ import annotations

import struct
import zlib

import numpy as np
import pytest

import boxwood as bw


def read_png(data):
    """The pixels of a PNG file of 8 bits without palettes, by nothing but zlib."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, body = 8, b""
    while at < len(data):
        (size,), kind = struct.unpack(">I", data[at : at + 4]), data[at + 4 : at + 8]
        content = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", content[:10])
            assert depth == 8
            channels = {2: 3, 6: 4}[color]
        if kind == b"IDAT":
            body += content
        at += size + 12
    rows = np.frombuffer(zlib.decompress(body), np.uint8).reshape(height, 1 + width * channels)
    pixels = np.zeros((height + 1, width + 1, channels), int)
    for y, row in enumerate(rows):
        deltas = row[1:].reshape(width, channels).astype(int)
        for x in range(width):
            left, above, corner = pixels[y + 1, x], pixels[y, x + 1], pixels[y, x]
            guess = left + above - corner
            far = [np.abs(guess - p) for p in (left, above, corner)]
            paeth = np.where(
                (far[0] <= far[1]) & (far[0] <= far[2]),
                left,
                np.where(far[1] <= far[2], above, corner),
            )
            base = [0, left, above, (left + above) // 2, paeth][row[0]]
            pixels[y + 1, x + 1] = (deltas[x] + base) % 256
    return pixels[1:, 1:]


@pytest.mark.parametrize("shape", [(5, 7), (5, 7, 3), (5, 7, 4), (1, 1)])
@pytest.mark.parametrize("dtype", [np.uint8, np.float32, np.float64])
def test_pixels_come_back_from_the_file(tmp_path, shape, dtype):
    rng = np.random.default_rng(1)
    values = rng.integers(0, 256, shape)
    pixels = values.astype(np.uint8) if dtype == np.uint8 else (values / 255).astype(dtype)
    image = bw.Image(pixels)
    assert (image.height, image.width) == shape[:2]
    expected = values if values.ndim == 3 else np.repeat(values[..., None], 3, axis=2)
    assert image.numpy().dtype == np.uint8
    np.testing.assert_array_equal(image.numpy(), expected)
    np.testing.assert_array_equal(np.asarray(image), expected)
    image.save(tmp_path / "image.png")
    for data in ((tmp_path / "image.png").read_bytes(), image._repr_png_()):
        np.testing.assert_array_equal(read_png(data)[..., : expected.shape[2]], expected)


def test_what_is_too_bright_or_not_a_number_can_be_shown():
    image = bw.Image(np.array([[-1.0, 2.0, np.nan, np.inf]]))
    assert image.numpy()[0, :2, 0].tolist() == [0, 255]


def test_other_names_and_folders_are_refused(tmp_path):
    image = bw.Image(np.zeros((2, 2)))
    with pytest.raises(ValueError, match=r"\.png"):
        image.save(tmp_path / "image.jpg")
    with pytest.raises(OSError):
        image.save(tmp_path / "no" / "image.png")


def test_pictures_of_hits(ball):
    camera = bw.PinholeCamera([0, 0, 4], [0, 0, 0], width=32, height=24)
    hits = bw.Scene(ball).closest_hit(*camera.rays())
    for image in (
        bw.Image.of_depth(hits.t),
        bw.Image.of_normal(hits.normal),
        bw.Image.of_ids(hits.triangle),
    ):
        pixels = image.numpy()
        assert pixels.shape == (24, 32, 3)
        assert (pixels[~hits.hit] == 0).all() and (pixels[hits.hit].max(axis=1) > 0).all()
    depth = bw.Image.of_depth(hits.t).numpy()[..., 0]
    assert depth[12, 16] == depth.max() == 255
    normal = bw.Image.of_normal(hits.normal).numpy()
    np.testing.assert_allclose(
        normal[hits.hit], (0.5 + 0.5 * hits.normal[hits.hit]) * 255, atol=0.51
    )
    colors = bw.Image.of_ids(np.arange(1000).reshape(10, 100)).numpy().reshape(-1, 3)
    assert len(np.unique(colors, axis=0)) > 950
