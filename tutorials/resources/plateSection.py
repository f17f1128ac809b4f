#!/usr/bin/env python3
#------------------------------------------------------------------------------
# monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
# Copyright (C) 2026 the monolithicFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Module
#     plateSection
#
# Description
#     Triangles round the section of a plate with round ends, in rows parallel to
#     it as far as a given distance (near), and from there to the outline of a
#     larger domain (far), and those of the section itself (plate).  The axis of
#     the plate is that of x, its middle x = 0.
#------------------------------------------------------------------------------

import math

import structuredMesh


def graded(n, ratio):
    """n + 1 numbers from 0 to 1, the last step so many times the first"""

    steps = [ratio**(i/max(n - 1, 1)) for i in range(n)]
    return [sum(steps[:i])/sum(steps) for i in range(n + 1)]


def alongOutline(outline, n):
    """n points round a closed polygon, its corners among them, all but equally
    far from each other"""

    sides = list(zip(outline, outline[1:] + outline[:1]))
    lengths = [math.dist(a, b) for a, b in sides]
    ends = [round(n*sum(lengths[:i + 1])/sum(lengths)) for i in range(len(sides))]
    points = []
    for (a, b), start, end in zip(sides, [0] + ends, ends):
        m = end - start
        points += [tuple(p + i/m*(q - p) for p, q in zip(a, b)) for i in range(m)]
    return points


class Section:
    """points: of the nodes; triangles: of nodes, counterclockwise; zones: plate,
    near, far of each. rows: of the rim, of each row around it; the last one is
    the outer outline"""

    def __init__(self, half, radius, nSide, nEnd, near, nNear, outline, nOuter, growth=(2.5, 1.8), nSweeps=8):
        self.points, self.triangles, self.zones = [], [], []
        end = graded(nSide//2, 0.5)
        nSide = 2*(nSide//2)
        axis = [-half*s for s in end[::-1]] + [half*s for s in end[1:]]
        turn = [(math.pi/2 + math.pi*i/nEnd) for i in range(nEnd)]
        rim = [(-x, (0, 1)) for x in axis[:-1]]
        rim += [(-half, (math.cos(a), math.sin(a))) for a in turn]
        rim += [(x, (0, -1)) for x in axis[:-1]]
        rim += [(half, (-math.cos(a), -math.sin(a))) for a in turn]

        rows = [[(x + d*n[0], d*n[1]) for x, n in rim] for d in
            (radius + near*s for s in graded(nNear, growth[0]))]
        # The middle of the right end meets the point of the outline that is first
        n, shift = len(rim), 2*nSide + nEnd + nEnd//2
        outer = outline(n)
        outer = [outer[(i - shift) % n] for i in range(n)]
        for s in graded(nOuter, growth[1])[1:]:
            rows.append([tuple((1 - s)*p + s*q for p, q in zip(a, b)) for a, b in zip(rows[nNear], outer)])
        self.rows = [[self.add(p) for p in row] for row in rows]
        for j in range(nNear + nOuter):
            for i in range(n):
                low, high = self.rows[j], self.rows[j + 1]
                self.quad([low[i - 1], high[i - 1], high[i], low[i]], 'near' if j < nNear else 'far')
        self.improve(nSweeps, set(self.rows[nNear]) | set(self.rows[-1]))
        self.plate(axis, nSide, nEnd)

    def add(self, point):
        self.points.append(point)
        return len(self.points) - 1

    def quad(self, v, zone):
        """Two triangles of the corners, once round, by the shorter diagonal"""

        p = [self.points[i] for i in v]
        if math.dist(p[0], p[2]) > math.dist(p[1], p[3]):
            v = v[1:] + v[:1]
        self.triangle([v[0], v[1], v[2]], zone)
        self.triangle([v[0], v[2], v[3]], zone)

    def triangle(self, v, zone):
        self.triangles.append(v if self.area(v) > 0 else v[::-1])
        self.zones.append(zone)

    def area(self, v):
        (ax, ay), (bx, by), (cx, cy) = (self.points[i] for i in v)
        return ((bx - ax)*(cy - ay) - (by - ay)*(cx - ax))/2

    def flip(self, far):
        """The other diagonal of two triangles where that is Delaunay's"""

        opposite = {}
        for t in far:
            v = self.triangles[t]
            for i in range(3):
                opposite[v[i], v[i - 2]] = (t, v[i - 1])
        for (a, b), (t, c) in list(opposite.items()):
            if a > b or (b, a) not in opposite or opposite.get((a, b)) != (t, c):
                continue
            u, d = opposite[b, a]
            angles = 0
            for e in (c, d):
                p, q = ([x - y for x, y in zip(self.points[f], self.points[e])] for f in (a, b))
                angles += math.acos((p[0]*q[0] + p[1]*q[1])/math.hypot(*p)/math.hypot(*q))
            if angles < math.pi + 1e-6 or min(self.area([a, d, c]), self.area([d, b, c])) <= 0:
                continue
            self.triangles[t], self.triangles[u] = [a, d, c], [d, b, c]
            for edge in ((a, b), (b, a)):
                del opposite[edge]
            for t, v in ((t, [a, d, c]), (u, [d, b, c])):
                for i in range(3):
                    opposite[v[i], v[i - 2]] = (t, v[i - 1])

    def improve(self, nSweeps, held):
        """Flip edges between far triangles, move nodes between their neighbours"""

        far = [t for t, zone in enumerate(self.zones) if zone == 'far']
        for sweep in range(nSweeps):
            self.flip(far)
            around = {}
            for t in far:
                for n in self.triangles[t]:
                    around.setdefault(n, []).append(t)
            for n, cells in around.items():
                if n in held:
                    continue
                near, before = {m for t in cells for m in self.triangles[t]} - {n}, self.points[n]
                self.points[n] = tuple(sum(self.points[m][a] for m in near)/len(near) for a in (0, 1))
                if min(self.area(self.triangles[t]) for t in cells) <= 0:
                    self.points[n] = before

    def plate(self, axis, nSide, nEnd):
        """A row of nodes on the axis, joined with the rim"""

        rim, n = self.rows[0], len(self.rows[0])
        middle = [self.add((-x, 0)) for x in axis]
        above = [rim[i] for i in range(nSide + 1)]
        below = [rim[(2*nSide + nEnd - i) % n] for i in range(nSide + 1)]
        for i in range(nSide):
            self.quad([middle[i], above[i], above[i + 1], middle[i + 1]], 'plate')
            self.quad([middle[i], middle[i + 1], below[i + 1], below[i]], 'plate')
        for centre, first in ((middle[-1], nSide), (middle[0], 2*nSide + nEnd)):
            for i in range(nEnd):
                self.triangle([centre, rim[first + i], rim[(first + i + 1) % n]], 'plate')


# -- Meshes of one cell or of many through the third direction; nodes are pairs
#    of a point's number and a layer's

def planeFaces(t):
    low, high = [[(v, k) for v in t] for k in (0, 1)]
    return [low[::-1], high] + [[low[i - 1], low[i], high[i], high[i - 1]] for i in range(3)]


def tetsFaces(t, k, place):
    """The prism on a triangle between layers k and k + 1 as three tetrahedra,
    whose diagonals go up from the smaller number to the larger"""

    a, b, c = sorted(t)
    path = [(a, k), (b, k), (c, k), (c, k + 1), (b, k + 1), (a, k + 1)]
    for v in ([path[0], path[1], path[2], path[3]], [path[0], path[1], path[4], path[3]],
            [path[0], path[5], path[4], path[3]]):
        p, q, r, s = (place(n) for n in v)
        u, w, x = ([b - a for a, b in zip(p, o)] for o in (q, r, s))
        volume = (u[1]*w[2] - u[2]*w[1])*x[0] + (u[2]*w[0] - u[0]*w[2])*x[1] + (u[0]*w[1] - u[1]*w[0])*x[2]
        if volume < 0:
            v[0], v[1] = v[1], v[0]
        yield [[v[i] for i in f] for f in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))]


def write(directory, region, cells, zones, patches, place):
    """patches: names with (type, whether the face of some nodes belongs to it)"""

    def patchOf(face):
        return next(name for name, (kind, holds) in patches.items() if holds(face))

    nodes, faces, owner, neighbour, sizes = structuredMesh.topology(
        cells, patchOf, {name: kind for name, (kind, holds) in patches.items()})
    structuredMesh.write(directory, region, [place(n) for n in nodes], faces, owner, neighbour, sizes, zones)
    print('%s: %d points, %d cells: %s' % (region, len(nodes), len(cells),
        ', '.join('%d in %s' % (len(zone), name) for name, zone in zones.items())))


def writePlane(directory, region, section, names, patches, depth):
    """Some zones of a section, by the names of their cellZones, one cell thick; to
    the patches comes frontAndBack"""

    cells, zones = [], {name: [] for name in names.values()}
    for t, zone in zip(section.triangles, section.zones):
        if zone in names:
            zones[names[zone]].append(len(cells))
            cells.append(planeFaces(t))
    all = {'frontAndBack': ('empty', lambda face: len({k for n, k in face}) == 1)}
    all.update(patches)
    write(directory, region, cells, zones, all, lambda node: section.points[node[0]] + (depth*node[1],))

#------------------------------------------------------------------------------
