/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowAssemblyBlock.H"

compileFlow(EQUAL_ORDER, true, true);
compileFamily(EQUAL_ORDER);

// ************************************************************************* //
