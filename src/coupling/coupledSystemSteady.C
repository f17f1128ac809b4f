/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    A steady state by a pseudo-transient, where Newton's method does not find
    it: steps of Euler's scheme with all loads and values as they are at the end
    of the steady step, each from rest, so that a solid does not swing,

        M (v - 0)/deltaT + R(x + deltaT v) = 0,   M (u - u_0)/deltaT + R(u) = 0

    and each solved to a tenth of the residual that it starts with. deltaT is
    that of the steady step at first, a quarter after a step that fails, and
    grows by 4 after one of two iterations or less, by 2 after one of four or
    less, but for some steps not to where it has failed. What it starts with is the residual of the steady equations; when that
    has fallen to a hundredth of the largest, and by each tenth part after, they
    are tried.

    Source: C.T. Kelley, D.E. Keyes, SIAM J. Numer. Anal. 35 (1998) 508-523.
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "fourDigits.H"
#include "IStringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::coupledSystem::isSteady() const
{
    bool steady = true;
    for (const feRegion& region : regions_) steady = steady && region.timeScheme().steady();
    return steady;
}


Foam::coupledSystem::schemes Foam::coupledSystem::EulerSchemes() const
{
    const dictionary Euler(IStringStream("type Euler;")());
    schemes list;
    for (label r = 0; r < regions_.size(); ++r)
    {
        list.append(new autoPtr<feTimeScheme>(feTimeScheme::New(Euler)));
    }
    return list;
}


void Foam::coupledSystem::exchange(schemes& others)
{
    forAll(regions_, r) regions_[r].exchange(others[r]);
}


void Foam::coupledSystem::stopRates()
{
    const auto isRate = [](const word& name)
    {
        return name.endsWith("Rate") || name.endsWith("Velocity") || name.endsWith("Acceleration");
    };
    for (feRegion& region : regions_)
    {
        for (statePart& part : region.state().parts())
        {
            const HashTable<scalarField*> scalars(part.scalars());
            const HashTable<vectorField*> vectors(part.vectors());
            forAllConstIters(scalars, iter) if (isRate(iter.key())) *iter.val() = 0;
            forAllConstIters(vectors, iter) if (isRate(iter.key())) *iter.val() = Zero;
        }
        region.state().shift();
    }
}


bool Foam::coupledSystem::pseudoStep(const scalar deltaT, scalarField& largest, scalar& part)
{
    predict(deltaT, deltaT);
    newton_.start(newtonControl::pseudoStep, tangent_->patience());
    const bool ok = newtonLoop();

    part = 0;
    forAll(largest, b)
    {
        largest[b] = max(largest[b], norms_->first()[b]);
        if (largest[b] > 0) part = max(part, norms_->first()[b]/largest[b]);
    }
    Info<< "Pseudo-step of " << fourDigits(deltaT) << " s from a residual of " << fourDigits(part)
        << " of the largest" << (ok ? "" : " failed") << nl;
    return ok;
}


bool Foam::coupledSystem::steadyLoop(schemes& Euler)
{
    exchange(Euler);
    tangent_->drop();
    predict();
    newton_.start(newton_.ways()[0], tangent_->patience());
    const bool ok = newtonLoop();
    if (!ok)
    {
        exchange(Euler);
        tangent_->drop();
    }
    return ok;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::coupledSystem::pseudoTransient()
{
    static const label most = 200;
    schemes Euler(EulerSchemes());
    exchange(Euler);
    tangent_->drop();
    stopRates();

    moment good(now());
    label wait = 0;
    scalar deltaT = runTime_.deltaTValue(), failed = GREAT, part, wanted = 1e-2;
    const scalar least = 1e-9*deltaT;
    scalarField largest(norms_->nBlocks(), 0);
    for (label n = 0; n < most && deltaT > least; ++n)
    {
        if (!pseudoStep(deltaT, largest, part))
        {
            if (!newton_.mayTurn()) break;
            set(good);
            failed = deltaT;
            wait = 4;
            deltaT *= 0.25;
            continue;
        }
        stopRates();
        good = now();
        if (part < wanted)
        {
            if (steadyLoop(Euler)) return true;
            set(good);
            wanted = 0.1*part;
        }
        deltaT *= newton_.nIterations() <= 2 ? 4 : newton_.nIterations() <= 4 ? 2 : 1;
        if (wait-- > 0) deltaT = min(deltaT, 0.5*failed);
    }
    exchange(Euler);
    return false;
}


// ************************************************************************* //
