/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowLedger.H"
#include "solidLedger.H"
#include "emptyPolyPatch.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::energyLedger::ofPatches(const scalarField& ofMesh) const
{
    return scalarField(ofMesh, patches_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::energyLedger::energyLedger(const feRegion& region)
:
    region_(region),
    start_(0)
{
    for (const polyPatch& pp : region.mesh().boundaryMesh())
    {
        if (!pp.coupled() && !isA<emptyPolyPatch>(pp)) patches_.append(pp.index());
    }
}


Foam::autoPtr<Foam::energyLedger> Foam::energyLedger::New(const feRegion& region)
{
    if (const auto* fluid = dynamic_cast<const hasFlowEnergy*>(&region))
    {
        return autoPtr<energyLedger>(new flowLedger(region, *fluid));
    }
    if (const auto* solid = dynamic_cast<const nonlinearSolid*>(&region))
    {
        return autoPtr<energyLedger>(new solidLedger(*solid));
    }
    return nullptr;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::energyLedger::patchNames() const
{
    wordList names;
    for (const label patchi : patches_) names.append(region_.mesh().boundaryMesh()[patchi].name());
    return names;
}


void Foam::energyLedger::begin(const dictionary& before)
{
    stored_ = storedNow();
    start_ = before.lookupOrDefault<scalar>("start", sum(stored_));
    integral_.begin(before, PATCHES + patches_.size());
}


void Foam::energyLedger::enter()
{
    integral_.add(region_.timeScheme(), powersOfStep(stored_));
}


void Foam::energyLedger::keep(dictionary& to) const
{
    to.set("start", start_);
    integral_.keep(to);
}


Foam::scalar Foam::energyLedger::scheme() const
{
    scalar balance = start_ + work(WEIGHT) + boundary() - sum(stored_);
    for (label i = VISCOUS; i <= TRANSPORT; ++i) balance -= work(i);
    return balance;
}


// ************************************************************************* //
