#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the bag for bag.test: parts of a unit sphere about the origin of "map", each from another place."""
import math
import random
import struct
import sys

import rosbag
import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import PointCloud2, PointField
from tf2_msgs.msg import TFMessage

CLOUDS, POINTS = 12, 150  # node_test.cpp knows them, and the stamps

dice = random.Random(5)


def direction():
    p = [dice.gauss(0, 1) for _ in range(3)]
    length = math.sqrt(sum(x * x for x in p))
    return [x / length for x in p]


with rosbag.Bag(sys.argv[1], "w") as bag:
    for k in range(CLOUDS):
        stamp = rospy.Time.from_sec(2000 + 0.25 * k)
        x0, y0 = 2 * math.cos(k), 2 * math.sin(k)
        transform = TransformStamped()
        transform.header.stamp = stamp
        transform.header.frame_id = "map"
        transform.child_frame_id = "scanner"
        transform.transform.translation.x = x0
        transform.transform.translation.y = y0
        transform.transform.rotation.z = math.sin(0.5 * k)  # turned about z by k
        transform.transform.rotation.w = math.cos(0.5 * k)
        bag.write("/tf", TFMessage([transform]), stamp)

        cloud = PointCloud2(height=1, width=POINTS, point_step=12, row_step=12 * POINTS, is_dense=True)
        cloud.header.frame_id = "scanner"
        cloud.header.stamp = stamp
        cloud.fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate("xyz")]
        for _ in range(POINTS):
            x, y, z = direction()
            x, y = x - x0, y - y0
            cloud.data += struct.pack("<3f", x * math.cos(k) + y * math.sin(k), y * math.cos(k) - x * math.sin(k), z)
        bag.write("/scanner/points", cloud, stamp)
