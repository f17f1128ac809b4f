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
view.ViewSize = [1000, 260]
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
    bar = GetScalarBar(GetColorTransferFunction(field[1]), view)
    bar.Title, bar.ComponentTitle = title, ''
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.ScalarBarLength = 0.6


def has(region):
    return os.path.isdir(os.path.join('constant', region, 'polyMesh'))


for region in 'fluid', 'solid':
    if not has(region):
        continue
    reader = OpenFOAMReader(FileName=path)
    reader.MeshRegions = ['/%s/internalMesh' % region]
    reader.UpdatePipelineInformation()
    time = max(reader.TimestepValues)
    view.ViewTime = time

    if region == 'fluid':
        display = Show(inside(reader, time), view)
        colour(display, ('POINTS', 'U', 'Magnitude'), '|U| [m/s]', True)
    else:
        # The solid's mesh stays where it was: move it by its displacement
        warp = WarpByVector(Input=reader, Vectors=['POINTS', 'D'])
        warp.ScaleFactor = 1
        display = Show(inside(warp, time), view)
        colour(display, ('POINTS', 'sigmaEq'), 'sigmaEq [Pa]', not has('fluid'))

ResetCamera(view)
camera = view.GetActiveCamera()
camera.Zoom(2.9 if has('fluid') else 1.2)
Render(view)
SaveScreenshot('picture.png', view)
