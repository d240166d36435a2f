#!/usr/bin/env python3
"""Writes outlines.inc: the glyph outlines of two TrueType fonts as numbers that results/font.cpp includes.

Command (Debian: fonts-dejavu-core), only needed to add a character:
  results/font/make_outlines.py /usr/share/fonts/truetype/dejavu > results/font/outlines.inc

Form of a row: code point, advance, number of contours, then for each contour its number of points and the points as
differences to the one before, with the on-curve bit in the lowest bit of dx: (dx * 2 + on, dy). Units: 2048 an em.
"""
import struct
import sys

REGULAR = [chr(c) for c in range(0x20, 0x7F)] + list("°±²³µ·×äöüÄÖÜßéèσαδεθΘΦκ–—‘’“”…→←↑↓≤≥≠≈√∞∥⊥✓✗−☐")
BOLD = [chr(c) for c in range(0x20, 0x7F)] + list("°±²×–—→·≥≤%")


class Font:
    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        count = struct.unpack(">H", self.data[4:6])[0]
        self.tables = {}
        for i in range(count):
            tag, _, offset, length = struct.unpack(">4sIII", self.data[12 + 16 * i : 28 + 16 * i])
            self.tables[tag.decode()] = (offset, length)
        head = self.tables["head"][0]
        self.long_loca = struct.unpack(">h", self.data[head + 50 : head + 52])[0] == 1
        self.long_metrics = self.u16(self.tables["hhea"][0] + 34)
        self.cmap = self.read_cmap()

    def u16(self, at):
        return struct.unpack(">H", self.data[at : at + 2])[0]

    def i16(self, at):
        return struct.unpack(">h", self.data[at : at + 2])[0]

    def read_cmap(self):
        base = self.tables["cmap"][0]
        for i in range(self.u16(base + 2)):
            offset = struct.unpack(">I", self.data[base + 8 + 8 * i : base + 12 + 8 * i])[0]
            at = base + offset
            if self.u16(at) != 4:
                continue
            half = self.u16(at + 6) // 2
            result = {}
            for s in range(half):
                end = self.u16(at + 14 + 2 * s)
                start = self.u16(at + 16 + 2 * half + 2 * s)
                delta = self.u16(at + 16 + 4 * half + 2 * s)
                range_at = at + 16 + 6 * half + 2 * s
                range_offset = self.u16(range_at)
                for c in range(start, min(end, 0xFFFE) + 1):
                    if range_offset == 0:
                        glyph = (c + delta) & 0xFFFF
                    else:
                        glyph = self.u16(range_at + range_offset + 2 * (c - start))
                        glyph = (glyph + delta) & 0xFFFF if glyph else 0
                    if glyph:
                        result[c] = glyph
            return result
        raise SystemExit("no cmap of format 4")

    def advance(self, glyph):
        return self.u16(self.tables["hmtx"][0] + 4 * min(glyph, self.long_metrics - 1))

    def contours(self, glyph):
        loca = self.tables["loca"][0]
        if self.long_loca:
            begin, end = struct.unpack(">II", self.data[loca + 4 * glyph : loca + 4 * glyph + 8])
        else:
            begin, end = 2 * self.u16(loca + 2 * glyph), 2 * self.u16(loca + 2 * glyph + 2)
        if begin == end:
            return []
        at = self.tables["glyf"][0] + begin
        if self.i16(at) < 0:
            return self.composite(at + 10)
        return self.simple(at)

    def composite(self, at):
        result = []
        while True:
            flags, glyph = self.u16(at), self.u16(at + 2)
            at += 4
            if flags & 1:
                dx, dy = self.i16(at), self.i16(at + 2)
                at += 4
            else:
                dx, dy = struct.unpack(">bb", self.data[at : at + 2])
                at += 2
            matrix = [1.0, 0.0, 0.0, 1.0]
            if flags & 8:
                matrix[0] = matrix[3] = self.i16(at) / 16384.0
                at += 2
            elif flags & 0x40:
                matrix[0], matrix[3] = self.i16(at) / 16384.0, self.i16(at + 2) / 16384.0
                at += 4
            elif flags & 0x80:
                matrix = [self.i16(at + 2 * k) / 16384.0 for k in range(4)]
                at += 8
            for contour in self.contours(glyph):
                result.append([(round(x * matrix[0] + y * matrix[2]) + dx, round(x * matrix[1] + y * matrix[3]) + dy, on)
                               for x, y, on in contour])
            if not flags & 0x20:
                return result

    def simple(self, at):
        count = self.i16(at)
        ends = [self.u16(at + 10 + 2 * k) for k in range(count)]
        points = ends[-1] + 1
        at += 10 + 2 * count
        at += 2 + self.u16(at)
        flags = []
        while len(flags) < points:
            flag = self.data[at]
            at += 1
            flags.append(flag)
            if flag & 8:
                flags += [flag] * self.data[at]
                at += 1

        def axis(short, same):
            nonlocal at
            value, values = 0, []
            for flag in flags:
                if flag & short:
                    value += self.data[at] if flag & same else -self.data[at]
                    at += 1
                elif not flag & same:
                    value += self.i16(at)
                    at += 2
                values.append(value)
            return values

        xs, ys = axis(2, 16), axis(4, 32)
        result, first = [], 0
        for end in ends:
            result.append([(xs[k], ys[k], flags[k] & 1) for k in range(first, end + 1)])
            first = end + 1
        return result


def dump(name, path, characters):
    font = Font(path)
    numbers, glyphs = [], 0
    for character in sorted(set(characters)):
        glyph = font.cmap.get(ord(character))
        if glyph is None:
            print(f"{path}: no {character!r}", file=sys.stderr)
            continue
        contours = font.contours(glyph)
        numbers += [ord(character), font.advance(glyph), len(contours)]
        for contour in contours:
            numbers.append(len(contour))
            last = (0, 0)
            for x, y, on in contour:
                numbers += [(x - last[0]) * 2 + on, y - last[1]]
                last = (x, y)
        glyphs += 1
    print(f"constexpr int {name}_glyphs = {glyphs};")
    print(f"constexpr std::int16_t {name}_outlines[] = {{")
    line = ""
    for number in numbers:
        text = f"{number},"
        if len(line) + len(text) > 118:
            print(line)
            line = ""
        line += text
    print(line + "};")


folder = sys.argv[1]
print("// Written by make_outlines.py from DejaVu Sans; licence in results/font/LICENSE. Do not edit.")
dump("regular", f"{folder}/DejaVuSans.ttf", REGULAR)
dump("bold", f"{folder}/DejaVuSans-Bold.ttf", BOLD)
