#------------------------------------------------------------------------------
# monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
# Copyright (C) 2026 the monolithicFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Script
#     pvbatch wingPicture.py [-animation]
#
# Description
#     Of the flapping wing in the working directory, in the plane in the middle of
#     its span: picture.png, the velocity at the instants of Zhang and Zhu's
#     pictures, and mesh.png, the mesh at the times written before and after the
#     exchange that is nearest to 1.375 s. -animation writes instead a picture of
#     the velocity at each time there is, animation.<n>.png.
#------------------------------------------------------------------------------

import glob
import os
import re
import sys

from paraview.simple import (
    ColorBy, CreateRenderView, ExtractCellsByRegion, ForceTime, GetColorTransferFunction, GetScalarBar, OpenFOAMReader,
    Render, SaveScreenshot, Show, Slice, Transform)

INSTANTS = 0.375, 1.375, 1.5, 1.625, 2.625, 3
path = os.path.join(os.getcwd(), os.path.basename(os.getcwd()) + '.foam')
open(path, 'a').close()
fluid = OpenFOAMReader(FileName=path)
fluid.MeshRegions = ['/fluid/internalMesh']
fluid.UpdatePipelineInformation()


def number(name, index=0):
    """Of the parameters"""
    with open(os.path.join('constant', 'parameters')) as file:
        return float(re.search(r'(?m)^%s\s+\(?([-\d.e ]+)\)?;' % name, file.read()).group(1).split()[index])


middle = number('span')/2
length, height = (number('channelHigh', a) - number('channelLow', a) for a in (0, 1))


def panel(time, index, nColumns, cells=False):
    """The plane at a time, moved to its place among others"""

    at = ForceTime(Input=fluid, ForcedTime=time)
    if cells:
        cut = ExtractCellsByRegion(Input=at, IntersectWith='Plane', Extractonlyintersected=1, Extractintersected=1)
        plane = cut.IntersectWith
    else:
        cut = Slice(Input=at)
        plane = cut.SliceType
    plane.Origin, plane.Normal = [0, 0, middle + 1e-5], [0, 0, 1]
    row, column = divmod(index, nColumns)
    moved = Transform(Input=cut)
    moved.Transform.Translate = [1.04*column*length, -1.06*row*height, 0]
    return moved


def newView(nColumns, nRows):
    view = CreateRenderView()
    view.ViewSize = [1200, int(1200*(1.06*nRows*height + 0.25)/(1.04*nColumns*length))]
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0
    return view


def save(view, nColumns, nRows, name):
    Render(view)
    view.CameraParallelProjection = 1
    x = number('channelLow') + 1.04*nColumns*length/2 - 0.02*length
    y = number('channelHigh', 1) - (1.06*nRows*height + 0.25)/2 + 0.03
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [x, y, 0], [x, y, 10], [0, 1, 0]
    view.CameraParallelScale = (1.06*nRows*height + 0.25)/2
    SaveScreenshot(name, view)


def velocity(times, nColumns, name):
    view = newView(nColumns, -(-len(times)//nColumns))
    for i, time in enumerate(times):
        display = Show(panel(time, i, nColumns), view)
        ColorBy(display, ('POINTS', 'U', 'Magnitude'))
        display.SetScalarBarVisibility(view, i == 0)
    table = GetColorTransferFunction('U')
    table.RescaleTransferFunction(0, 2)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = '|U| [m/s]', ''
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.Orientation, bar.WindowLocation = 'Horizontal', 'Lower Center'
    save(view, nColumns, -(-len(times)//nColumns), name)


def meshes(times):
    view = newView(len(times), 1)
    for i, time in enumerate(times):
        display = Show(panel(time, i, len(times), True), view)
        display.SetRepresentationType('Surface With Edges')
        ColorBy(display, None)
        display.DiffuseColor = [0.85, 0.9, 1]
    save(view, len(times), 1, 'mesh.png')


def exchanges():
    found = []
    for table in glob.glob(os.path.join('postProcessing', 'remeshing', 'fluid', '*', '*.dat')):
        with open(table) as file:
            found += [float(line.split()[0]) for line in file if not line.startswith('#')]
    return found


written = list(fluid.TimestepValues)
if '-animation' in sys.argv:
    for i, time in enumerate(written):
        velocity([time], 1, 'animation.%04d.png' % i)
else:
    velocity([t for t in INSTANTS if any(abs(t - w) < 1e-6 for w in written)], 3, 'picture.png')
    if exchanges():
        at = min(exchanges(), key=lambda t: abs(t - 1.375))
        meshes([max(t for t in written if t < at), min(t for t in written if t > at)])
#------------------------------------------------------------------------------
