/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Residual and tangent of aleFluid at the stage of the time scheme.
\*---------------------------------------------------------------------------*/

#include "aleFluid.H"
#include "coastingScheme.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aleFluid::stage()
{
    const feTimeScheme& ts = timeScheme();
    v_.stage(ts, stage_.v, stage_.a);
    if (incompressible())
    {
        stage_.p = q_.v;
        stage_.q = 0;
    }
    else
    {
        q_.stage(ts, stage_.p, stage_.q);
    }
    motion_.displacement().stage(ts, stage_.x, stage_.vm, meshAcceleration_);
    stage_.x += fe().points();

    k_.dadv = k_.dqdp = ts.rateByValue();
    k_.dvmdm = ts.steady() ? 0 : ts.velocityByUnknown()/ts.displacementByUnknown();
    k_.deltaT = ts.steady() ? GREAT : coastingScheme::step(ts);
    stage_.s = k_.tracked ? &subscales_.old : nullptr;
    stage_.widest2 = filter_.valid() ? &filter_->widest2() : nullptr;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aleFluid::assemble(scalarField& R, feMatrix* K)
{
    const feTimeScheme& ts = timeScheme();
    stage();
    force_ = Zero;
    continuity_ = 0;

    feMatrix* S = motion_.S();
    if (K && S) S->clear();
    flowMatrices to;
    to.K = K;
    to.S = S;
    to.scatter = &scatter_;
    to.shapeScatter = &motion_.scatter();
    to.columns = ts.alphaF();
    if (ts.steady() && !motion_.following().empty())
    {
        to.heldNodes.setSize(fe().nNodes(), false);
        for (const label n : motion_.following()) to.heldNodes[n] = true;
    }
    minDetJ_ = assembly_->assemble(k_, stage_, force_, continuity_, K ? &to : nullptr);

    loads_->addSurface
    ({
        k_.rho, ts.alphaF(), stageTime(), stage_, unknowns(), force_, K, K ? S : nullptr, motion_.position(),
        k_.dvmdm
    });
    if (source) addVolumeLoad(fe(), stage_.x, source, stageTime(), force_);

    unknowns().add(VELOCITY, force_, R);
    unknowns().add(PRESSURE, continuity_, R);
}


// ************************************************************************* //
