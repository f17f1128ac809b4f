/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-coupling

Description
    Tests of parts of src/coupling on their own; those of the whole system are
    in tests/tangent/system. On any number of ranks:

        test-coupling
        mpirun -np 2 test-coupling -parallel
\*---------------------------------------------------------------------------*/

#include "runOnRanks.H"

int main(int argc, char* argv[]) { return Foam::runOnRanks(argc, argv); }


// ************************************************************************* //
