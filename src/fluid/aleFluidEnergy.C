/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Energy of aleFluid and the powers that change it: flowEnergy.
\*---------------------------------------------------------------------------*/

#include "aleFluid.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::flowEnergy Foam::aleFluid::energy() const
{
    flowFields end(stage_);
    end.x = fe().points() + motion_.displacement().D;
    end.v = v_.v;
    end.p = endPressure();

    // The powers of these values are of no use, and their tau must not be infinite
    flowParameters k(k_);
    k.transient = true;
    k.tracked = false;
    k.deltaT = 1;
    const flowEnergy now(assembly_->energy(k, end));

    // Before the first step there is no stage
    flowEnergy all;
    if (minDetJ_ < GREAT) all = assembly_->energy(k_, stage_);
    all.kinetic = now.kinetic;
    all.compression = now.compression;
    return all;
}


Foam::scalarField Foam::aleFluid::boundaryPowers() const
{
    scalarField power(mesh_.boundaryMesh().size(), 0);
    boolList counted(fe().nNodes(), false);
    forAll(power, patchi)
    {
        const pointPatchVectorField& pf = pointU_().boundaryField()[patchi];
        if (!nodalBoundary::isNatural(pf) || motion_.follows(patchi))
        {
            for (const label n : fe().patchNodes(patchi))
            {
                if (!counted[n]) power[patchi] += force_[n] & stage_.v[n];
                counted[n] = true;
            }
        }

        // Loads are in the residual with the other sign
        vectorField load(fe().nNodes(), Zero);
        const flowLoads::job job
        {
            k_.rho, timeScheme().alphaF(), stageTime(), stage_, unknowns(), load, nullptr, nullptr, nullptr, 0
        };
        if (!loads_->addPatch(patchi, job)) continue;
        for (const label n : fe().patchNodes(patchi)) power[patchi] -= load[n] & stage_.v[n];
    }
    reduce(power, sumOp<scalarField>());
    return power;
}


// ************************************************************************* //
