#------------------------------------------------------------------------------
# monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
# Copyright (C) 2026 the monolithicFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Module
#     cases
#
# Description
#     Cases of the convergence tests: meshes of the unit box, dictionaries, the
#     program test-manufactured, and rates from the errors it prints.
#------------------------------------------------------------------------------

import math
import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
HEADER = 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n'


# -- Environment ---------------------------------------------------------------

def shell(command, log):
    """Run a command with the environment of etc/bashrc; its output"""

    os.environ.setdefault('OMP_NUM_THREADS', '1')
    result = subprocess.run(['bash', '-c', '. %s/etc/bashrc && %s' % (ROOT, command)],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    with open(log, 'w') as file:
        file.write(result.stdout)
    if result.returncode:
        at = result.stdout.find('FOAM FATAL')
        raise SystemExit('FAIL %s runs: exit status %d, see %s: %s' % (
            command.split()[0], result.returncode, log,
            ' '.join(result.stdout[at:].split()[:60]) if at >= 0 else ''))
    return result.stdout


def scratch():
    """An empty directory of this test"""

    group, test = os.path.dirname(os.path.abspath(sys.argv[0])).split(os.sep)[-2:]
    base = os.path.join(ROOT, 'tests', 'scratch')
    directory = os.path.join(base, group + '.' + test)
    shutil.rmtree(directory, ignore_errors=True)
    os.makedirs(directory)
    with open(os.path.join(base, '.gitignore'), 'w') as file:
        file.write('*\n')
    if group == 'convergence':
        shell('wmake -s %s/manufactured' % HERE, os.path.join(directory, 'log.wmake'))
    return directory


# -- Meshes of the unit box ----------------------------------------------------

def distorted(x, dim):
    """Moves the inside, smoothly, and leaves the sides as they are"""

    bump = math.sin(math.pi*x[0])*math.sin(math.pi*x[1])
    if dim == 3:
        bump *= math.sin(math.pi*x[2])
    shift = (0.08*bump, -0.06*bump, 0.05*bump if dim == 3 else 0)
    return tuple(a + b for a, b in zip(x, shift))


def brickCells(kind, v):
    """Cells of a brick with corners numbered as OpenFOAM's hex, by faces"""

    hexFaces = lambda c: [(c[0], c[3], c[2], c[1]), (c[4], c[5], c[6], c[7]),
        (c[0], c[1], c[5], c[4]), (c[2], c[3], c[7], c[6]),
        (c[0], c[4], c[7], c[3]), (c[1], c[2], c[6], c[5])]
    prism = lambda c: [(c[0], c[2], c[1]), (c[3], c[4], c[5]), (c[0], c[1], c[4], c[3]),
        (c[1], c[2], c[5], c[4]), (c[2], c[0], c[3], c[5])]
    tet = lambda c: [(c[0], c[2], c[1]), (c[0], c[1], c[3]), (c[1], c[2], c[3]), (c[2], c[0], c[3])]
    if kind in ('quad', 'hex'):
        return [hexFaces(v)]
    if kind in ('tri', 'prism'):
        return [prism([v[i] for i in c]) for c in ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7))]
    ring = (1, 2, 3, 7, 4, 5)
    return [tet((v[0], v[ring[i]], v[ring[(i + 1) % 6]], v[6])) for i in range(6)]


def scattered(nCells, ranks, shift=0):
    """Rank of each cell: parts that touch each other, and patches, in all ways"""

    return [(5*i + i//7 + shift) % ranks for i in range(nCells)]


def writeMesh(directory, kind, n, distort=True, place=lambda x: x, part=lambda x: True):
    """polyMesh of n elements a side: quad, tri, hex, prism or tet; patches left,
    right, bottom, top, back, front; place puts the unit box elsewhere. Of the
    n^dim bricks only those in whose centre part(x) is true; where this makes new
    sides, these are the patch interface. Returns the number of cells"""

    dim = 2 if kind in ('quad', 'tri') else 3
    nz = 1 if dim == 2 else n
    index = lambda i, j, k: (k*(n + 1) + j)*(n + 1) + i
    unit = [(i/n, j/n, k/nz) for k in range(nz + 1) for j in range(n + 1) for i in range(n + 1)]
    cells = []
    for k in range(nz):
        for j in range(n):
            for i in range(n):
                if not part(((i + 0.5)/n, (j + 0.5)/n, (k + 0.5)/nz)):
                    continue
                cells += brickCells(kind, [index(i + a, j + b, k + c)
                    for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])

    seen, inner, outer = {}, [], [[] for _ in range(7)]
    for celli, faces in enumerate(cells):
        for face in faces:
            key = tuple(sorted(face))
            if key in seen:
                owner, ownFace = seen.pop(key)
                inner.append((owner, celli, ownFace))
            else:
                seen[key] = (celli, face)
    inner.sort()
    for celli, face in seen.values():
        sides = [2*a + side for a in range(3) for side in (0, 1) if all(unit[p][a] == side for p in face)]
        outer[sides[0] if sides else 6].append((celli, None, face))
    faces = inner + sum(outer, [])

    used = sorted({p for _, _, face in faces for p in face})
    number = {p: i for i, p in enumerate(used)}
    points = [place(distorted(unit[p], dim) if distort else unit[p]) for p in used]
    os.makedirs(directory, exist_ok=True)

    def write(name, what, rows):
        with open(os.path.join(directory, name), 'w') as file:
            file.write(HEADER % (what, name) + '%d\n(\n' % len(rows))
            file.writelines(row + '\n' for row in rows)
            file.write(')\n')

    write('points', 'vectorField', ['(%.17g %.17g %.17g)' % x for x in points])
    write('faces', 'faceList', ['%d(%s)' % (len(f), ' '.join(str(number[p]) for p in f)) for _, _, f in faces])
    write('owner', 'labelList', [str(f[0]) for f in faces])
    write('neighbour', 'labelList', [str(f[1]) for f in inner])
    start, rows = len(inner), []
    for name, side in zip(('left', 'right', 'bottom', 'top', 'back', 'front', 'interface'), outer):
        if name == 'interface' and not side:
            continue
        patchType = 'empty' if dim == 2 and name in ('back', 'front') else 'patch'
        rows.append('%s { type %s; nFaces %d; startFace %d; }' % (name, patchType, len(side), start))
        start += len(side)
    write('boundary', 'polyBoundaryMesh', rows)
    return len(cells)


# -- Cases ---------------------------------------------------------------------

def writeFile(directory, name, content, what='dictionary'):
    path = os.path.join(directory, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w') as file:
        file.write(HEADER % (what, os.path.basename(name)) + content + '\n')


def field(name, dimensions, boundary, dim):
    """A point field: conditions of the sides, empty ones in 2-D"""

    sides = dict(boundary)
    ends = 'type empty;' if dim == 2 else None
    for end in ('back', 'front'):
        sides[end] = ends or sides['default']
    rows = '\n'.join('    %s { %s }' % (s, sides.get(s, sides['default']))
        for s in ('left', 'right', 'bottom', 'top', 'back', 'front'))
    zero = '0' if name == 'pointP' else '(0 0 0)'
    return 'dimensions [%s];\ninternalField uniform %s;\nboundaryField\n{\n%s\n}' % (
        dimensions, zero, rows)


def writeCase(directory, region, kind, n, elements, timeScheme='type steady;', solution='smooth',
        deltaT=1, endTime=1, material='StVenantKirchhoff', distort=True, flow=None):
    """A case of the region fluid or solid alone; flow: further entries of a fluid's
    feSchemes, transportProperties, turbulenceProperties and initialConditions by these
    names, and moves, by which its left side moves"""

    flow = flow or {}

    dim = 2 if kind in ('quad', 'tri') else 3
    fluid = region == 'fluid'
    writeFile(directory, 'system/controlDict', '''
application test-manufactured; solution %s; dimensions %d;
regionSolvers { %s %s; }
startFrom startTime; startTime 0; stopAt endTime; endTime %.17g; deltaT %.17g;
writeControl timeStep; writeInterval 1000000; timePrecision 12;''' % (
        solution, dim, region, 'aleFluid' if fluid else 'nonlinearSolid', endTime, deltaT))
    for place in ('system', 'system/' + region):
        writeFile(directory, place + '/fvSchemes', 'divSchemes {} gradSchemes {} laplacianSchemes {}')
        writeFile(directory, place + '/fvSolution', '')
    writeFile(directory, 'system/feSolution',
        'newton { tolerance 1e-11; maxIter 30; }\nlinearSolver { type MUMPS; }')
    writeFile(directory, 'system/%s/feSchemes' % region,
        'elements %s;\ntimeScheme { %s }\n%s' % (elements, timeScheme, flow.get('feSchemes', '')))
    writeFile(directory, 'constant/regionProperties',
        'regions ( %s (%s) );' % (region, region))

    given = 'type manufactured; value uniform (0 0 0);'
    if fluid:
        writeFile(directory, 'constant/fluid/transportProperties',
            'rho [1 -3 0 0 0 0 0] 1;\nmu [1 -1 -1 0 0 0 0] 0.1;\n' + flow.get('transportProperties', ''))
        if 'turbulenceProperties' in flow:
            writeFile(directory, 'constant/fluid/turbulenceProperties', flow['turbulenceProperties'])
        if 'initialConditions' in flow:
            writeFile(directory, 'system/fluid/initialConditions', flow['initialConditions'])
        if 'moves' in flow:
            writeMotion(directory, flow['moves'], dim)
        left = given.replace(';', '; moves %s;' % flow['moves'], 1) if 'moves' in flow else given
        right = 'type manufacturedLoad; of flow; normal (1 0 0); value uniform (0 0 0);'
        if solution not in ('transported', 'Kovasznay'):
            right = 'type openBoundary; backflowStabilisation 0; value uniform (0 0 0);'
        writeFile(directory, '0/fluid/pointU', field('pointU', '0 1 -1 0 0 0 0', {
            'default': given, 'left': left, 'right': right}, dim), 'pointVectorField')
        writeFile(directory, '0/fluid/pointP', field('pointP', '1 -1 -2 0 0 0 0', {
            'default': 'type zeroGradient;'}, dim), 'pointScalarField')
    else:
        writeFile(directory, 'constant/solid/mechanicalProperties',
            'materials ( body { type %s; rho 1; E 10; nu 0.3; } );' % material)
        writeFile(directory, '0/solid/pointD', field('pointD', '0 1 0 0 0 0 0', {
            'default': given}, dim), 'pointVectorField')
    writeMesh(os.path.join(directory, 'constant', region, 'polyMesh'), kind, n, distort)


def writeMotion(directory, moves, dim):
    """The left side of a fluid moves, the others rest"""

    writeFile(directory, 'constant/fluid/dynamicMeshDict',
        'motionSolver feLaplacian; feLaplacianCoeffs { stiffness uniform; }')
    writeFile(directory, '0/fluid/pointDisplacement', field('pointDisplacement', '0 1 0 0 0 0 0', {
        'default': 'type fixedValue; value uniform (0 0 0);',
        'left': 'type manufactured; moves %s; value uniform (0 0 0);' % moves},
        dim), 'pointVectorField')


def solve(directory):
    """Errors by name that test-manufactured prints"""

    output = shell('cd %s && test-manufactured' % directory, os.path.join(directory, 'log'))
    errors = {}
    for line in output.split('\n'):
        if line.startswith('errors '):
            words = line.split()[1:]
            errors.update(zip(words[::2], map(float, words[1::2])))
    return errors


# -- Rates ---------------------------------------------------------------------

class Report:
    """The lines PASS and FAIL and the exit status"""

    def __init__(self):
        self.failures = 0

    def verdict(self, requirement, good, numbers):
        print('PASS ' + requirement if good else 'FAIL %s: %s' % (requirement, numbers), flush=True)
        self.failures += not good

    def rates(self, requirement, sizes, errors, expected):
        """sizes: of the elements or steps; errors: dictionaries; expected:
        lowest rate of each name between the last two"""

        rows = []
        for name, lowest in expected.items():
            values = [e[name] for e in errors]
            rate = [math.log(values[i]/values[i + 1])/math.log(sizes[i]/sizes[i + 1])
                for i in range(len(values) - 1)]
            print('    %-3s errors %s  rates %s  expected %.2f' % (name,
                ' '.join('%.3e' % v for v in values), ' '.join('%.2f' % r for r in rate), lowest))
            rows.append((rate[-1] >= lowest and values[-1] < 0.1, name, rate[-1], lowest))
        self.verdict(requirement, all(row[0] for row in rows),
            ', '.join('%s %.2f (at least %.2f)' % row[1:] for row in rows if not row[0]))

    def finish(self, directory):
        if not self.failures and not os.environ.get('MONOLITHICFOAM_KEEP'):
            shutil.rmtree(directory)
        sys.exit(self.failures > 0)
