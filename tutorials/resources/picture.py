#------------------------------------------------------------------------------
# monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
# Copyright (C) 2026 the monolithicFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Script
#     pvbatch picture.py
#
# Description
#     Writes picture.png of the case in the working directory at its last time:
#     the fluid coloured by velocity, the displaced solid by equivalent stress.
#------------------------------------------------------------------------------

import os

from paraview.simple import (
    ColorBy, GetActiveViewOrCreate, GetColorTransferFunction, GetScalarBar, OpenFOAMReader, Render,
    ResetCamera, SaveScreenshot, Show, Slice, WarpByVector)

case = os.path.basename(os.getcwd())
path = os.path.join(os.getcwd(), case + '.foam')
open(path, 'a').close()

view = GetActiveViewOrCreate('RenderView')
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0

def inside(source, time):
    """The plane at a quarter of the depth: a 3-D case shows its walls else"""
    source.UpdatePipeline(time)
    bounds = source.GetDataInformation().GetBounds()
    plane = Slice(Input=source)
    plane.SliceType.Normal = [0, 0, 1]
    plane.SliceType.Origin = [0, 0, bounds[4] + 0.25*(bounds[5] - bounds[4])]
    return plane


def colour(display, field, title, bar):
    """Colour by a field over its range, with a bar if wanted"""
    ColorBy(display, field)
    display.RescaleTransferFunctionToDataRange(True)
    display.SetScalarBarVisibility(view, bar)
    if not bar:
        return
    bar = GetScalarBar(GetColorTransferFunction(field[1]), view)
    bar.Title, bar.ComponentTitle = title, ''
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.ScalarBarLength = 0.6


def has(region):
    return os.path.isdir(os.path.join('constant', region, 'polyMesh'))


planes = []
for region in 'fluid', 'solid':
    if not has(region):
        continue
    reader = OpenFOAMReader(FileName=path)
    reader.MeshRegions = ['/%s/internalMesh' % region]
    reader.UpdatePipelineInformation()
    time = max(reader.TimestepValues)
    view.ViewTime = time

    if region == 'fluid':
        planes.append(inside(reader, time))
        display = Show(planes[-1], view)
        colour(display, ('POINTS', 'U', 'Magnitude'), '|U| [m/s]', True)
    else:
        # The solid's mesh stays where it was: move it by its displacement
        warp = WarpByVector(Input=reader, Vectors=['POINTS', 'D'])
        warp.ScaleFactor = 1
        planes.append(inside(warp, time))
        display = Show(planes[-1], view)
        colour(display, ('POINTS', 'sigmaEq'), 'sigmaEq [Pa]', not has('fluid'))

# The regions fill the height, or the width left of the bar
for plane in planes:
    plane.UpdatePipeline(time)
bounds = list(zip(*(plane.GetDataInformation().GetBounds() for plane in planes)))
xMin, xMax, yMin, yMax, z = (choose(b) for choose, b in zip((min, max, min, max, min), bounds))
width, height = xMax - xMin, yMax - yMin
view.ViewSize = [1000, int(min(max(800*height/width*1.3, 260), 440))]
scale = max(1.1*height/view.ViewSize[1], width/0.8/view.ViewSize[0])    # m a pixel
centre = [0.5*(xMin + xMax) + 60*scale, 0.5*(yMin + yMax), z]
ResetCamera(view)
view.CameraParallelProjection = 1
view.CameraFocalPoint = centre
view.CameraPosition = centre[:2] + [z + 10*width]
view.CameraParallelScale = 0.5*scale*view.ViewSize[1]
Render(view)
SaveScreenshot('picture.png', view)
