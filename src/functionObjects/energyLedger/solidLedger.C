/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidLedger.H"
#include "surfaceSupport.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::solidLedger::patchOfNodes() const
{
    // The largest merit, of all ranks
    const feMesh& fe = solid_.fe();
    const label nPatches = solid_.mesh().boundaryMesh().size();
    scalarField merit(fe.nNodes(), -1);
    for (const label patchi : patches_)
    {
        const pointPatchVectorField& pf = solid_.motionConditions().boundaryField()[patchi];
        const bool loads =
            dynamic_cast<const surfaceLoad*>(&pf) || dynamic_cast<const surfaceSupport*>(&pf);
        const label kind = !nodalBoundary::isNatural(pf) ? 2 : loads ? 1 : 0;
        const scalar own = kind*nPatches + nPatches - 1 - patchi;
        for (const label n : fe.patchNodes(patchi)) merit[n] = max(merit[n], own);
    }
    fe.copies().maximum(merit);

    labelList patch(fe.nNodes(), -1);
    forAll(patch, n)
    {
        if (merit[n] >= 0) patch[n] = nPatches - 1 - label(merit[n]) % nPatches;
    }
    return patch;
}


Foam::scalarField Foam::solidLedger::storedNow() const
{
    const solidIntegrals s(solid_.integrals());
    scalarField stored(nStored, 0);
    stored[KINETIC] = s.kinetic;
    stored[STRAIN] = s.strain;
    stored[POTENTIAL] = s.weight;
    return stored;
}


Foam::scalarField Foam::solidLedger::powersOfStep(scalarField& stored)
{
    stored = storedNow();

    const scalarField atNodes(atPatches_(solid_, solid_.loads() + solid_.force()));
    scalarField ofMesh(solid_.mesh().boundaryMesh().size(), 0);
    const labelList patch(patchOfNodes());
    forAll(patch, n) if (patch[n] >= 0) ofMesh[patch[n]] += atNodes[n];

    scalarField p(PATCHES, 0);
    p[MATERIAL] = sum(viscous_(solid_, solid_.viscousForces()));
    p.append(ofPatches(ofMesh));
    reduce(p, sumOp<scalarField>());
    return p;
}


// ************************************************************************* //
