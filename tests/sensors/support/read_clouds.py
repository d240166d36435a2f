"""Reads a data set of `scanchor generate --pcd --ply` with numpy and nothing of ours, from what the
formats' own documents say, and holds the forms against each other. For the test of the same name."""

import hashlib
import json
import os
import sys

import numpy as np

PCD_TYPES = {("F", 4): "f4", ("F", 8): "f8", ("U", 1): "u1", ("U", 2): "u2", ("U", 4): "u4",
             ("I", 1): "i1", ("I", 2): "i2", ("I", 4): "i4"}
PLY_TYPES = {"float": "f4", "float32": "f4", "double": "f8", "float64": "f8", "uchar": "u1", "uint8": "u1",
             "char": "i1", "int8": "i1", "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
             "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4"}


def read_pcd(path):
    """PCD v0.7, binary: https://pointclouds.org/documentation/tutorials/pcd_file_format.html"""
    data = open(path, "rb").read()
    header = {}
    at = 0
    while "DATA" not in header:
        end = data.index(b"\n", at)
        words = data[at:end].decode("ascii").split()
        at = end + 1
        if words and not words[0].startswith("#"):
            header[words[0]] = words[1:]
    assert header["VERSION"][0] in ("0.7", ".7"), header["VERSION"]
    assert header["DATA"] == ["binary"], header["DATA"]
    counts = [int(c) for c in header["COUNT"]]
    assert all(c == 1 for c in counts)
    kinds = [PCD_TYPES[t, int(s)] for t, s in zip(header["TYPE"], header["SIZE"])]
    dtype = np.dtype([(n, "<" + k) for n, k in zip(header["FIELDS"], kinds)])
    points = int(header["POINTS"][0])
    assert points == int(header["WIDTH"][0]) * int(header["HEIGHT"][0])
    assert len(data) - at == points * dtype.itemsize, (len(data) - at, points, dtype.itemsize)
    return np.frombuffer(data, dtype, points, at)


def read_ply(path):
    """Turk's PLY, binary_little_endian, one element of scalars."""
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    lines = data[:end].decode("ascii").split("\n")
    assert lines[0] == "ply" and lines[1] == "format binary_little_endian 1.0", lines[:2]
    fields, points = [], None
    for line in lines[2:]:
        words = line.split()
        if words[:2] == ["element", "vertex"]:
            points = int(words[2])
        elif words[:1] == ["element"]:
            break  # what follows the vertices is not asked for
        elif words[:1] == ["property"]:
            fields.append((words[2], "<" + PLY_TYPES[words[1]]))
    dtype = np.dtype(fields)
    assert len(data) - end >= points * dtype.itemsize
    return np.frombuffer(data, dtype, points, end)


def main(root):
    card = json.load(open(os.path.join(root, "dataset.json")))
    scans = 0
    for name in sorted(os.listdir(os.path.join(root, "sequences"))):
        folder = os.path.join(root, "sequences", name)
        poses = np.loadtxt(os.path.join(folder, "poses.txt"), ndmin=2)
        for k, file in enumerate(sorted(os.listdir(os.path.join(folder, "velodyne")))):
            number = file[:-4]
            scans += 1
            # As semantic-kitti-api's laserscan.py reads them.
            scan = np.fromfile(os.path.join(folder, "velodyne", file), dtype=np.float32).reshape((-1, 4))
            label = np.fromfile(os.path.join(folder, "labels", number + ".label"), dtype=np.uint32)
            assert label.shape[0] == scan.shape[0]
            semantic, instance = label & 0xFFFF, label >> 16
            assert np.isfinite(scan).all() and poses.shape[1] == 12
            truth = np.load(os.path.join(folder, "truth", number + ".npy"))
            assert truth.shape == label.shape
            # float32 positions: their length is the measured range, the truth is near it.
            ranges = np.linalg.norm(scan[:, :3].astype(np.float64), axis=1)
            plain = truth["flags"] == 0
            assert np.std((ranges - truth["true_range"])[plain]) < 0.02
            for cloud in (read_pcd(os.path.join(folder, "pcd", number + ".pcd")),
                          read_ply(os.path.join(folder, "ply", number + ".ply"))):
                assert cloud.shape == label.shape, (cloud.shape, label.shape)
                for axis, column in zip("xyz", scan.T):
                    assert np.array_equal(cloud[axis].astype(np.float32), column), axis
                # pcl::PointXYZL matches fields by name and type: x, y, z F4 and label U4.
                assert cloud.dtype["label"] == np.uint32 and cloud.dtype["x"] == np.float32
                assert np.array_equal(cloud["label"], semantic)
                assert np.array_equal(cloud["instance"].astype(np.int64).clip(0), instance)
                assert np.array_equal(cloud["intensity"].astype(np.float32), scan[:, 3])
                assert np.array_equal(cloud["face"].astype(np.int64), truth["face"])
    assert scans == card["scans"]
    listed = set()
    for name, record in card["files"].items():
        data = open(os.path.join(root, name), "rb").read()
        assert len(data) == record["bytes"] and hashlib.sha256(data).hexdigest() == record["sha256"], name
        listed.add(name)
    print(f"{scans} scans, {len(listed)} files agree")


main(sys.argv[1])
