"""An independent reader of a data set, with the conventions of semantic-kitti-api (laserscan.py, generate_sequential.py).

Knows nothing of the project. Needs numpy. Prints for each scan: sequence, scan, points, sums over labels, instances and faces, and the
translation of the sensor. Usage: read_dataset.py ROOT
"""
import os
import sys

import numpy as np


def parse_calibration(path):
    calib = {}
    with open(path) as file:
        for line in file:
            key, content = line.strip().split(":")
            values = [float(v) for v in content.strip().split()]
            pose = np.eye(4)
            pose[:3, :4] = np.array(values).reshape(3, 4)
            calib[key] = pose
    return calib


def parse_poses(path, calibration):
    tr = calibration["Tr"]
    tr_inv = np.linalg.inv(tr)
    poses = []
    with open(path) as file:
        for line in file:
            values = [float(v) for v in line.strip().split()]
            pose = np.eye(4)
            pose[:3, :4] = np.array(values).reshape(3, 4)
            poses.append(tr_inv @ pose @ tr)
    return poses


root = sys.argv[1]
for sequence in sorted(os.listdir(os.path.join(root, "sequences")), key=int):
    folder = os.path.join(root, "sequences", "{0:02d}".format(int(sequence)))
    poses = parse_poses(os.path.join(folder, "poses.txt"), parse_calibration(os.path.join(folder, "calib.txt")))
    times = np.loadtxt(os.path.join(folder, "times.txt"), ndmin=1)
    scans = sorted(os.listdir(os.path.join(folder, "velodyne")))
    assert len(scans) == len(poses) == len(times)
    for k, name in enumerate(scans):
        number = name[:-4]
        points = np.fromfile(os.path.join(folder, "velodyne", name), dtype=np.float32).reshape((-1, 4))
        label = np.fromfile(os.path.join(folder, "labels", number + ".label"), dtype=np.uint32)
        assert label.shape[0] == points.shape[0]
        truth = np.load(os.path.join(folder, "truth", number + ".npy"))
        assert truth.shape[0] == points.shape[0]
        # What was measured is where the beam went: noise apart, the range is the true range.
        ranges = np.linalg.norm(points[:, :3], axis=1)
        assert np.median(np.abs(ranges - truth["true_range"])) < 0.05
        x, y, z = poses[k][:3, 3]
        print(sequence, k, points.shape[0], (label & 0xFFFF).sum(), (label >> 16).sum(), truth["face"].sum(dtype=np.int64),
              "%.9f %.9f %.9f" % (x, y, z))
