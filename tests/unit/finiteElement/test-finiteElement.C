/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-finiteElement

Description
    Tests of src/finiteElement. On several ranks, those that are about ranks:

        test-finiteElement
        mpirun -np 3 test-finiteElement -parallel
\*---------------------------------------------------------------------------*/

#include "runOnRanks.H"

int main(int argc, char* argv[]) { return Foam::runOnRanks(argc, argv, "nodeMap.*:decomposed.*:*OnRanks.*"); }


// ************************************************************************* //
