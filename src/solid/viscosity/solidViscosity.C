/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidViscosity.H"
#include "readNumber.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidViscosity::solidViscosity(const dictionary& material)
:
    mass_(0),
    stiffness_(0),
    Prony_(material.lookupOrDefault("Prony", List<Tuple2<scalar, scalar>>()))
{
    const dictionary damping(subDictOrEmpty(material, "damping"));
    reportUnknownEntries(damping, {"mass", "stiffness"});
    if (damping.found("mass")) mass_ = readNotNegative(damping, "mass", dimless/dimTime);
    if (damping.found("stiffness")) stiffness_ = readNotNegative(damping, "stiffness", dimTime);
    for (const auto& branch : Prony_)
    {
        const scalar g = branch.first(), tau = branch.second();
        if (g >= 0 && g < GREAT && tau > 0 && tau < GREAT) continue;
        FatalIOErrorInFunction(material)
            << "Found (g tau) " << branch << " in Prony, expected g >= 0, a part of the"
            << " law's own stiffness, and tau > 0 s" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::solidViscosity::decay(const label i, const scalar deltaT) const
{
    return std::exp(-deltaT/Prony_[i].second());
}


Foam::scalar Foam::solidViscosity::growth(const label i, const scalar deltaT) const
{
    const scalar x = deltaT/Prony_[i].second();
    return -std::expm1(-x)/x;
}


// ************************************************************************* //
