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
#     the fluid coloured by velocity, the solid in grey.
#------------------------------------------------------------------------------

import os

from paraview.simple import (
    ColorBy, GetActiveViewOrCreate, OpenFOAMReader, Render, ResetCamera, SaveScreenshot, Show)

case = os.path.basename(os.getcwd())
path = os.path.join(os.getcwd(), case + '.foam')
open(path, 'a').close()

view = GetActiveViewOrCreate('RenderView')
view.ViewSize = [800, 300]
view.Background = [1, 1, 1]

for region in 'fluid', 'solid':
    if not os.path.isdir(os.path.join('constant', region, 'polyMesh')):
        continue
    reader = OpenFOAMReader(FileName=path)
    reader.MeshRegions = ['%s/internalMesh' % region]
    reader.UpdatePipelineInformation()
    view.ViewTime = max(reader.TimestepValues)
    reader.UpdatePipeline(view.ViewTime)

    display = Show(reader, view)
    if region == 'fluid':
        ColorBy(display, ('POINTS', 'U', 'Magnitude'))
        display.RescaleTransferFunctionToDataRange(True)
        display.SetScalarBarVisibility(view, True)
    else:
        ColorBy(display, None)
        display.DiffuseColor = [0.5, 0.5, 0.5]

ResetCamera(view)
Render(view)
SaveScreenshot('picture.png', view)
