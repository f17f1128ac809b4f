/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowAssemblyBlock.H"

compileFlow(TAYLOR_HOOD, true, true);
compileFamily(TAYLOR_HOOD);

// ************************************************************************* //
