#!/usr/bin/env python3
#------------------------------------------------------------------------------
# monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
# Copyright (C) 2026 the monolithicFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Module
#     sweptMesh
#
# Description
#     Blocks of quadrilaterals in a plane between four curves, swept along z:
#     hexahedra, or three tetrahedra from each of the two prisms of one. A node
#     is a pair: number in the plane, layer.
#------------------------------------------------------------------------------

import itertools
import math

from structuredMesh import hexFaces, topology, write


def graded(start, end, n, ratio=1):
    """n + 1 numbers, each interval ratio times the last"""

    sizes = [ratio**i for i in range(n)]
    return [start + (end - start)*sum(sizes[:i])/sum(sizes) for i in range(n)] + [end]


def line(a, b, at):
    """Points on a line at fractions of it"""
    return [(a[0] + (b[0] - a[0])*t, a[1] + (b[1] - a[1])*t) for t in at]


def arc(centre, radius, start, end, at):
    """Points on an arc between two angles (degrees)"""

    angles = [math.radians(start + (end - start)*t) for t in at]
    return [(centre[0] + radius*math.cos(a), centre[1] + radius*math.sin(a)) for a in angles]


class Plane:
    """Points and quadrilaterals, anticlockwise"""

    def __init__(self):
        self.points, self.quads, self.number = [], [], {}

    def point(self, x):
        key = (round(x[0], 9), round(x[1], 9))
        if key not in self.number:
            self.number[key] = len(self.points)
            self.points.append(x)
        return self.number[key]

    def block(self, low, high, at):
        """Between two curves of as many points, at fractions of the way"""

        rows = [[self.point((a[0] + (b[0] - a[0])*t, a[1] + (b[1] - a[1])*t))
            for a, b in zip(low, high)] for t in at]
        for below, above in zip(rows, rows[1:]):
            for i in range(len(low) - 1):
                self.quads.append((below[i], below[i + 1], above[i + 1], above[i]))


def hexes(quad, k):
    places = ((0, 0), (1, 0), (1, 1), (0, 1))
    return [hexFaces({p + (l,): (n, k + l) for p, n in zip(places, quad) for l in (0, 1)})]


def tets(quad, k):
    """Diagonals start at the smallest number, so that neighbours have the same"""

    first = quad.index(min(quad))
    q = quad[first:] + quad[:first]
    for triangle in ((q[0], q[1], q[2]), (q[0], q[2], q[3])):
        a, b, c = sorted(triangle)
        left = (a, b, c) in (triangle[i:] + triangle[:i] for i in range(3))
        low, high = [[(n, k + l) for n in (a, b, c)] for l in (0, 1)]
        for tet, positive in (
            ((low[0], low[1], low[2], high[2]), left),
            ((low[0], low[1], high[1], high[2]), not left),
            ((low[0], high[0], high[1], high[2]), left)
        ):
            w, x, y, z = tet if positive else (tet[0], tet[2], tet[1], tet[3])
            yield [[w, y, x], [w, x, z], [x, y, z], [y, w, z]]


def writeSwept(directory, region, plane, layers, split, patchOf, types):
    """layers: values of z; patchOf(positions of a face's points): its patch"""

    cells = []
    for k, quad in itertools.product(range(len(layers) - 1), plane.quads):
        cells += (tets if split else hexes)(quad, k)
    place = lambda node: plane.points[node[0]] + (layers[node[1]],)
    nodes, *rest = topology(cells, lambda face: patchOf([place(n) for n in face]), types)
    write(directory, region, [place(n) for n in nodes], *rest)
