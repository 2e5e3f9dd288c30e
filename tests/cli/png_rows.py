"""Reads PNG files for tests: rows without filters, every checksum looked at."""
import struct
import zlib


class Png:
    """width, height, bits of a channel, color type, palette and texts of a file, and its rows of bytes."""

    def __init__(self, data):
        assert data[:8] == b"\x89PNG\r\n\x1a\n"
        at, packed, self.palette, self.texts = 8, b"", [], {}
        while at < len(data):
            length, kind = struct.unpack_from(">I4s", data, at)
            body = data[at + 8:at + 8 + length]
            assert struct.unpack_from(">I", data, at + 8 + length)[0] == zlib.crc32(kind + body)
            if kind == b"IHDR":
                self.width, self.height, self.bits, self.color = struct.unpack_from(">IIBB", body)
            elif kind == b"PLTE":
                self.palette = [tuple(body[i:i + 3]) for i in range(0, length, 3)]
            elif kind == b"tEXt":
                key, text = body.split(b"\0", 1)
                self.texts[key.decode()] = text.decode()
            elif kind == b"IDAT":
                packed += body
            at += length + 12
        assert kind == b"IEND"
        self.size, self.file_size = len(packed), len(data)
        self.rows = self._unfiltered(zlib.decompress(packed))

    def _unfiltered(self, raw):
        bits_of_pixel = self.bits * (3 if self.color == 2 else 1)
        stride, step = (self.width * bits_of_pixel + 7) // 8, max(bits_of_pixel // 8, 1)
        assert len(raw) == self.height * (stride + 1)
        rows, before = [], bytearray(stride)
        for y in range(self.height):
            method, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
            for i in range(stride if method else 0):
                left, up, corner = row[i - step] if i >= step else 0, before[i], before[i - step] if i >= step else 0
                nearest = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))[2]
                row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[method]) & 255
            rows.append(bytes(row))
            before = row
        return rows
