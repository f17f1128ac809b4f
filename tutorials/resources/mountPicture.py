#------------------------------------------------------------------------------
# monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
# Copyright (C) 2026 the monolithicFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Script
#     pvbatch mountPicture.py [-animation]
#
# Description
#     Of the oscillating engine mount in the working directory, in the plane y = 0,
#     at the last four times, which are a quarter of a cycle apart: picture.0.png to
#     picture.3.png, the displaced rubber coloured by pressure, -tr(sigma)/3, the fluid
#     by velocity, up to 1 m/s or the environment's mountVelocity.
#     -animation writes a picture of each time there is, animation.<n>.png.
#------------------------------------------------------------------------------

import os
import sys

from paraview.simple import (
    Calculator, ColorBy, CreateRenderView, GetColorTransferFunction, GetScalarBar, OpenFOAMReader, Render,
    SaveScreenshot, Show, Slice, WarpByVector)

path = os.path.join(os.getcwd(), os.path.basename(os.getcwd()) + '.foam')
open(path, 'a').close()


def reader(region):
    source = OpenFOAMReader(FileName=path)
    source.MeshRegions = ['/%s/internalMesh' % region]
    source.UpdatePipelineInformation()
    return source


def plane(source):
    cut = Slice(Input=source)
    cut.SliceType.Origin, cut.SliceType.Normal = [0, 1e-5, 0], [0, 1, 0]
    return cut


fluid, rubber = reader('fluid'), reader('rubber')
times = [t for t in rubber.TimestepValues if t > 1000]
if '-animation' not in sys.argv:
    times = times[-4:]
warp = WarpByVector(Input=rubber, Vectors=['POINTS', 'D'])
pressure = Calculator(Input=warp, Function='-(sigma_XX + sigma_YY + sigma_ZZ)/3e3', ResultArrayName='pressure')

RANGES = {'U': (0, float(os.environ.get('mountVelocity', 1))), 'pressure': (-100, 300)}


def colour(display, view, field, title, place):
    ColorBy(display, field)
    table = GetColorTransferFunction(field[1])
    table.RescaleTransferFunction(*RANGES[field[1]])
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ''
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.Orientation, bar.WindowLocation, bar.Position = 'Horizontal', 'Any Location', place
    bar.ScalarBarLength = 0.35
    display.SetScalarBarVisibility(view, True)


def picture(time, name):
    view = CreateRenderView()
    view.ViewSize = [800, 760]
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0
    view.ViewTime = time
    colour(Show(plane(fluid), view), view, ('POINTS', 'U', 'Magnitude'), '|U| [m/s]', [0.08, 0.02])
    colour(Show(plane(pressure), view), view, ('POINTS', 'pressure'), 'pressure of the rubber [kPa]', [0.55, 0.02])
    view.CameraParallelProjection = 1
    view.CameraFocalPoint, view.CameraPosition = [0, 0, 0.014], [0, -1, 0.014]
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelScale = 0.055
    Render(view)
    SaveScreenshot(name, view)


for i, time in enumerate(times):
    picture(time, 'animation.%04d.png' % i if '-animation' in sys.argv else 'picture.%d.png' % i)
