"""An independent reader: prints name, type and SHA-256 (of the values as little-endian float64) of each column of a cloud file.

Knows nothing of the project. Needs numpy. Usage: read_cloud.py FILE [LABELS]
"""
import hashlib
import sys

import numpy as np


def read_pcd(data):
    header, dtype = {}, []
    while "DATA" not in header:
        line, data = data.split(b"\n", 1)
        words = line.decode().split()
        if not words[0].startswith("#"):
            header[words[0]] = words[1:]
    for name, size, kind in zip(header["FIELDS"], header["SIZE"], header["TYPE"]):
        dtype.append((name, "<" + {"F": "f", "I": "i", "U": "u"}[kind] + size))
    count = int(header["WIDTH"][0]) * int(header["HEIGHT"][0])
    assert count == int(header["POINTS"][0])
    if header["DATA"][0] == "binary":
        assert len(data) == count * np.dtype(dtype).itemsize
        return np.frombuffer(data, dtype)
    rows = [tuple(line.split()) for line in data.decode().splitlines()]
    return np.array(rows, dtype)


def read_ply(data):
    head, data = data.split(b"end_header\n", 1)
    kinds = {"float": "f4", "double": "f8", "int": "i4", "uint": "u4", "ushort": "u2", "uchar": "u1"}
    order, dtype, count = "<", [], 0
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "format":
            order = {"binary_little_endian": "<", "binary_big_endian": ">", "ascii": ""}[words[1]]
        elif words[0] == "element":
            assert words[1] == "vertex"
            count = int(words[2])
        elif words[0] == "property":
            dtype.append((words[2], (order or "<") + kinds[words[1]]))
    if order:
        assert len(data) == count * np.dtype(dtype).itemsize
        return np.frombuffer(data, dtype)
    return np.array([tuple(line.split()) for line in data.decode().splitlines()], dtype)


def show(name, column):
    kind = column.dtype.kind + str(column.dtype.itemsize)
    print(name, kind, hashlib.sha256(column.astype("<f8").tobytes()).hexdigest())


path = sys.argv[1]
with open(path, "rb") as file:
    content = file.read()
if path.endswith(".bin"):
    points = np.frombuffer(content, "<f4").reshape(-1, 4)
    for k, axis in enumerate(["x", "y", "z", "intensity"]):
        show(axis, points[:, k])
    labels = np.fromfile(sys.argv[2], "<u4")
    show("label", (labels & 0xFFFF).astype(np.uint16))
    show("instance", (labels >> 16).astype(np.uint16))
else:
    table = read_pcd(content) if path.endswith(".pcd") else read_ply(content)
    for field in table.dtype.names:
        show(field, table[field])
