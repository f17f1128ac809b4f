/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowLedger.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

static Foam::scalarField storedOf(const Foam::flowEnergy& e)
{
    Foam::scalarField stored(Foam::energyLedger::nStored, 0);
    stored[Foam::energyLedger::KINETIC] = e.kinetic;
    stored[Foam::energyLedger::COMPRESSION] = e.compression;
    return stored;
}


Foam::scalarField Foam::flowLedger::storedNow() const
{
    return storedOf(fluid_.energy());
}


Foam::scalarField Foam::flowLedger::powersOfStep(scalarField& stored)
{
    const flowEnergy e(fluid_.energy());
    stored = storedOf(e);

    scalarField p(PATCHES, 0);
    p[WEIGHT] = e.weight;
    p[VISCOUS] = e.viscous;
    p[EDDY] = e.eddy;
    p[STABILISATION] = e.stabilisation;
    p[TRANSPORT] = e.transport;
    p.append(ofPatches(fluid_.boundaryPowers()));
    if (region_.timeScheme().steady()) p = 0;
    return p;
}


// ************************************************************************* //
