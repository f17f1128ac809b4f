#!/usr/bin/env python3
#------------------------------------------------------------------------------
# monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
# Copyright (C) 2026 the monolithicFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Module
#     structuredMesh
#
# Description
#     Meshes of cells that are numbered by three indices: hexahedra, the same split
#     into six tetrahedra or two prisms each, and how they are written as a
#     polyMesh.  A node is a triple of indices.
#------------------------------------------------------------------------------

import itertools
import os

HEADER = '''FoamFile
{{
    version     2.0;
    format      ascii;
    class       {type};
    location    "constant/{region}/polyMesh";
    object      {name};
}}

'''


def hexFaces(v):
    """Faces of a cell, normals outward, of v[i, j, k] with i, j, k in 0, 1"""
    return [[v[c] for c in face] for face in (
        ((0,0,0), (0,0,1), (0,1,1), (0,1,0)), ((1,0,0), (1,1,0), (1,1,1), (1,0,1)),
        ((0,0,0), (1,0,0), (1,0,1), (0,0,1)), ((0,1,0), (0,1,1), (1,1,1), (1,1,0)),
        ((0,0,0), (0,1,0), (1,1,0), (1,0,0)), ((0,0,1), (1,0,1), (1,1,1), (0,1,1)))]


def tetsFaces(v):
    """The same of the six tetrahedra round the diagonal (0 0 0) - (1 1 1): one
    for each order in which the directions can be walked"""

    for order in itertools.permutations(range(3)):
        corner, path = [0, 0, 0], [v[0, 0, 0]]
        for direction in order:
            corner[direction] = 1
            path.append(v[tuple(corner)])
        a, b, c, d = path
        if order not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            b, c = c, b
        yield [[a, c, b], [a, b, d], [b, c, d], [a, d, c]]


def fiveTetsFaces(v, inside):
    """The same of the tetrahedron of four corners that are no neighbours, inside,
    and of those that it leaves, one for each other corner"""

    for corner in v:
        if inside[corner]:
            continue
        near = [v[tuple(x ^ (a == b) for b, x in enumerate(corner))] for a in range(3)]
        a, (b, c, d) = v[corner], near if sum(corner) % 2 == 0 else near[::-1]
        yield [[a, c, b], [a, b, d], [b, c, d], [a, d, c]]
    a, b, c, d = (v[corner] for corner in sorted(v) if inside[corner])
    if not inside[0, 0, 0]:
        b, c = c, b
    yield [[a, c, b], [a, b, d], [b, c, d], [a, d, c]]


def prismsFaces(v):
    """The same of the two prisms along the third direction"""

    for a, b, c in (((0, 0), (1, 0), (0, 1)), ((1, 0), (1, 1), (0, 1))):
        low, high = [[v[p + (k,)] for p in (a, b, c)] for k in (0, 1)]
        sides = [[low[i], low[(i + 1)%3], high[(i + 1)%3], high[i]] for i in range(3)]
        yield [low[::-1], high] + sides


def corners(i, j, k):
    return {c: (i + c[0], j + c[1], k + c[2]) for c in itertools.product((0, 1), repeat=3)}


def topology(cells, patchOf, types):
    """Nodes, faces, owner, neighbour and patches (name, type, size, start) of
    cells that are lists of faces; patchOf a face of the boundary"""

    # A face met twice is internal, and belongs to the cell met first
    owned, internal = {}, []
    for celli, cell in enumerate(cells):
        for face in cell:
            key = frozenset(face)
            if key in owned:
                internal.append((owned[key][0], celli, owned.pop(key)[1]))
            else:
                owned[key] = (celli, face)
    internal.sort(key=lambda f: f[:2])

    boundary = {name: [] for name in types}
    for celli, face in owned.values():
        boundary[patchOf(face)].append((celli, face))

    faces, owner = [f[2] for f in internal], [f[0] for f in internal]
    patches = []
    for name, type in types.items():
        patches.append((name, type, len(boundary[name]), len(faces)))
        faces += [face for celli, face in boundary[name]]
        owner += [celli for celli, face in boundary[name]]

    nodes = sorted({p for face in faces for p in face}, key=lambda p: p[::-1])
    label = {p: n for n, p in enumerate(nodes)}
    return nodes, [[label[p] for p in f] for f in faces], owner, [f[1] for f in internal], patches


def write(directory, region, points, faces, owner, neighbour, patches, zones={}):
    """zones: cells by the names of cellZones"""

    os.makedirs(directory, exist_ok=True)

    def file(name, type, lines):
        with open(os.path.join(directory, name), 'w') as out:
            out.write(HEADER.format(type=type, region=region, name=name))
            out.write('%d\n(\n' % len(lines) + '\n'.join(lines) + '\n)\n')

    file('points', 'vectorField', ['(%.16g %.16g %.16g)' % p for p in points])
    file('faces', 'faceList', ['%d(%s)' % (len(f), ' '.join(map(str, f))) for f in faces])
    file('owner', 'labelList', [str(c) for c in owner])
    file('neighbour', 'labelList', [str(c) for c in neighbour])
    file('boundary', 'polyBoundaryMesh', [
        '    %s\n    {\n        type %s;\n        nFaces %d;\n        startFace %d;\n    }' % p
        for p in patches])
    if zones:
        file('cellZones', 'regIOobject', [
            '    %s\n    {\n        type cellZone;\n        cellLabels List<label> %d(%s);\n    }'
            % (name, len(cells), ' '.join(map(str, cells))) for name, cells in zones.items()])
